// Launcher of kernels/fold_hits.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// Completes tiles `first` .. `first + count` whose hits are made: gutters, cells and groups.
void fold_hits(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count);

}  // namespace pencil
