// Launcher of kernels/find_sides.cl.
#pragma once

#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// Words of a bit set over the sides of all shapes: bit 2 s is the front of shape s, bit 2 s + 1 its back.
inline std::size_t side_words(std::size_t shapes) { return (2 * shapes + 31) / 32; }

/// Per tile, in turn: side_words(shapes) words of the sides that it shows; backs only where they reflect.
std::vector<uint> find_sides(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps);

}  // namespace pencil
