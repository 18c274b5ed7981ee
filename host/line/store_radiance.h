// Launcher of kernels/store_radiance.cl.
#pragma once

#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"

namespace pencil {

/// Radiance that leaves the surfels of tiles `first` .. into the maps, then the gutters.
void store_radiance(Kernels& kernels, const Surfels& surfels, const Buffer<float>& outgoing, int first, int count, PencilSet& set);

}  // namespace pencil
