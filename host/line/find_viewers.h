// Launcher of kernels/find_viewers.cl.
#pragma once

#include <vector>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"

namespace pencil {

/// Per centre [scene units] how many of the surfels see it in front of them. The scene must have its hierarchy.
std::vector<int> find_viewers(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Buffer<float4>& centres);

}  // namespace pencil
