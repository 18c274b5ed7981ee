// Launcher of kernels/project_surface_pencils.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "surface/pencil_grid.h"
#include "surface/surface_pencils.h"
#include "surface/viewers.h"

namespace pencil {

/// Adds albedo / pi times the irradiance of the pencils near each surfel to outgoing[3][capacity] [W m^-2 sr^-1], but for contacts:
/// contact[surfel] becomes 1 where the viewer is nearer than `nearness` times the radius of the pencil, and elsewhere 0; nearness 0: none.
/// `irradiance`: of the pencils.
void project_surface_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const SurfacePencils& pencils,
                             const Buffer<float4>& irradiance, const DeviceGrid& grid, const Viewers& viewers, float nearness,
                             Buffer<float>& outgoing, Buffer<unsigned char>& contact);

}  // namespace pencil
