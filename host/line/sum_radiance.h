// Launcher of kernels/sum_radiance.cl.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "device/features.h"
#include "device/pencil_set.h"

namespace pencil {

/// Mean radiance over all texels of the set's maps [W m^-2 sr^-1].
glm::dvec3 sum_radiance(Kernels& kernels, const PencilSet& set);

/// The same of each map by itself, rgb.
std::vector<float4> mean_radiance(Kernels& kernels, const PencilSet& set);

}  // namespace pencil
