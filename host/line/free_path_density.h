// Launcher of kernels/free_path_density.cl.
#pragma once

#include <tuple>

#include "device/features.h"
#include "device/pencil_set.h"
#include "line/free_space.h"

namespace pencil {

/// Arguments `low, high, volume` of kernels: where centres lie evenly [normalised scene units].
std::tuple<float4, float4, float> even_density(const CentreSpace& space);

/// Analytic density weights of tiles `first` .. `first` + count - 1 into the w of the radiance maps. `space`: where the
/// centres lie, in normalised scene units.
void free_path_density(Kernels& kernels, int first, int count, const CentreSpace& space, PencilSet& set);

}  // namespace pencil
