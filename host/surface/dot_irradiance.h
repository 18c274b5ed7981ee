// Launcher of kernels/dot_irradiance.cl.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "device/features.h"

namespace pencil {

/// Inner products of the first `vectors` rows of `basis` (rows of `count` pencils) with `other`, channel by channel; parts are added up in
/// double precision.
std::vector<glm::dvec3> dot_irradiance(Kernels& kernels, const Buffer<float4>& basis, int vectors, const Buffer<float4>& other, int count);

}  // namespace pencil
