// Launcher of kernels/sum_hemispheres.cl.
#pragma once

#include "device/features.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// irradiance[first .. first + count] [W m^-2] of pencils of n x n texels: pi / n^2 times the sum of what these send,
/// radiance[3][capacity] [W m^-2 sr^-1] from first_surfel on.
void sum_hemispheres(Kernels& kernels, const Buffer<float>& radiance, int capacity, int first_surfel, int first, int count, int n,
                     Buffer<float4>& irradiance);

}  // namespace pencil
