// Launcher of kernels/rasterize_octahedral.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// Renders the geometry maps of tiles `first` .. `first + count` and folds their gutters.
void rasterize_octahedral(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count);

}  // namespace pencil
