// Launcher of kernels/project_surface_pencils.cl.
#pragma once

#include "device/features.h"
#include "device/surfels.h"
#include "surface/pencil_grid.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Adds albedo / pi times the irradiance of the pencils near each surfel to outgoing[3][capacity] [W m^-2 sr^-1].
void project_surface_pencils(Kernels& kernels, const Surfels& surfels, const SurfacePencils& pencils, const DeviceGrid& grid,
                             Buffer<float>& outgoing);

}  // namespace pencil
