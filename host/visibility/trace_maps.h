// Launcher of kernels/trace_maps.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// Traces the geometry maps of tiles `first` .. `first + count`, of any kind, and folds their gutters. The scene must have a hierarchy, and
/// maps.n be a multiple of 4.
void trace_maps(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count);

}  // namespace pencil
