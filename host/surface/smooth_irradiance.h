// Launcher of kernels/smooth_irradiance.cl.
#pragma once

#include "device/features.h"
#include "surface/film_lattice.h"

namespace pencil {

/// fits[3 * pencil ..]: irradiance near each pencil of the lattice as value [W m^-2] and slopes along its two tangents [W m^-2 / scene
/// unit], by weighted least squares over its neighbours, which count nothing from a reuse_error of most_error on.
void smooth_irradiance(Kernels& kernels, const PencilLattice& lattice, float most_error, int width, int height, Buffer<float4>& fits);

}  // namespace pencil
