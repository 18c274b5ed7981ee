// Launcher of kernels/gather_surfels.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"

namespace pencil {

/// Surfels of all texels of tiles `first` .. `first + count`, tile by tile, in the order of oct_surfel_texel. Sets surfels.count.
void gather_surfels(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps, int first, int count, Surfels& surfels);

}  // namespace pencil
