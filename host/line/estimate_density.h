// Launcher of kernels/estimate_density.cl.
#pragma once

#include "device/features.h"
#include "device/pencil_set.h"
#include "device/surfels.h"

namespace pencil {

/// 1/D of the texels of tiles `first` .. into the w of the radiance maps, thesis alg. 6.1. `surfels` and `mask` belong to these tiles.
void estimate_density(Kernels& kernels, const Surfels& surfels, const Buffer<uint>& mask, int first, PencilSet& set);

}  // namespace pencil
