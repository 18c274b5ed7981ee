// Launcher of kernels/trace_octahedral.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// As rasterize_octahedral; the scene must have a hierarchy, and maps.n be a multiple of 4.
void trace_octahedral(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count);

}  // namespace pencil
