// Launcher of kernels/measure_hemispheres.cl.
#pragma once

#include "device/features.h"
#include "device/surfels.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Harmonic mean distance and horizon of pencils first .. first + count from what their texels see, surfels first_surfel ..
void measure_hemispheres(Kernels& kernels, const Surfels& surfels, int first_surfel, int first, int count, SurfacePencils& pencils);

}  // namespace pencil
