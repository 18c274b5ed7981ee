// Launcher of kernels/close_series.cl.
#pragma once

#include <glm/vec3.hpp>

#include "device/features.h"

namespace pencil {

/// Adds what all bounces after the last would, tail * last, to the total of `count` pencils [W m^-2]; tail: BounceSeries::tail_factor.
void close_series(Kernels& kernels, const Buffer<float4>& last, const glm::vec3& tail, int count, Buffer<float4>& total);

}  // namespace pencil
