// Launcher of kernels/sum_guides.cl.
#pragma once

#include "device/features.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Adds to the irradiance of pencils first .. first + count what their rays towards spots carry, factors times radiance[3][capacity]: `rays` of
/// each, SPOT_RAYS from each of the places that it looks from, whose mean counts.
void sum_guides(Kernels& kernels, const Buffer<float>& radiance, int capacity, const Buffer<float>& factors, int rays, int first, int count,
                Buffer<float4>& irradiance);

}  // namespace pencil
