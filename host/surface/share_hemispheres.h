// Launcher of kernels/share_hemispheres.cl.
#pragma once

#include "device/features.h"
#include "surface/spots.h"
#include "surface/surface_pencils.h"
#include "surface/trace_hemispheres.h"

namespace pencil {

/// radiance[3][capacity] that the texels of pencils first .. first + count send, from the start, becomes the share of it that rays towards
/// the spots leave to texels. `points`, `map`: as trace_hemispheres had them.
void share_hemispheres(Kernels& kernels, const SurfacePencils& pencils, int first, int count, const DeviceSpots& spots,
                       const TexelPoints& points, Buffer<float>& radiance, int capacity, int map = 0);

}  // namespace pencil
