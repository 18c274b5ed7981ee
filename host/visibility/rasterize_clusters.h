// Launcher of kernels/rasterize_clusters.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// As rasterize_octahedral, for every kind of map that has facets; the scene must have clusters.
void rasterize_clusters(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count);

}  // namespace pencil
