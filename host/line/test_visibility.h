// Launcher of kernels/test_visibility.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"

namespace pencil {

/// Words of the visibility mask of `pencils` pencils for one surfel.
inline int mask_words(int pencils) { return (pencils + 31) / 32; }

/// mask[word][capacity]: which pencils see each surfel, thesis eq. (5.17).
void test_visibility(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const GeometryMaps& maps, Buffer<uint>& mask);

}  // namespace pencil
