// Launcher of kernels/find_enclosing.cl.
#pragma once

#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// Per tile the shape that encloses its centre, -1 if none does.
std::vector<int> find_enclosing(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps);

}  // namespace pencil
