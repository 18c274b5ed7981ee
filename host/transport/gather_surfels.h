// Launcher of kernels/gather_surfels.cl.
#pragma once

#include "transport/device_scene.h"
#include "transport/features.h"
#include "transport/pencil_set.h"
#include "transport/surfels.h"

namespace pencil {

/// Surfels of all texels of tiles `first` .. `first + count`, tile by tile, in the order of oct_surfel_texel. Sets surfels.count.
void gather_surfels(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps, int first, int count, Surfels& surfels);

}  // namespace pencil
