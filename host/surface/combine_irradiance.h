// Launcher of kernels/combine_irradiance.cl.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "device/features.h"

namespace pencil {

/// target += sum_k factors[k] row_k over the first rows of `vectors` (rows of `count` pencils), channel by channel.
void combine_irradiance(Kernels& kernels, const Buffer<float4>& vectors, const std::vector<glm::dvec3>& factors, int count,
                        Buffer<float4>& target);

}  // namespace pencil
