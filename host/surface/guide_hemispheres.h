// Launcher of kernels/guide_hemispheres.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "surface/spots.h"
#include "surface/surface_pencils.h"
#include "surface/trace_hemispheres.h"

namespace pencil {

/// Whether pencils may have the same keys, as those of one map do.
enum class Keys { own, shared };

/// SPOT_RAYS surfels of each of pencils first .. first + count that rays towards the spots meet, from the start of `surfels`, whose count
/// becomes their number; factors: irradiance for radiance along each ray [sr]. `points`: as their texels have it.
void guide_hemispheres(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count,
                       const DeviceSpots& spots, const TexelPoints& points, Surfels& surfels, Buffer<float>& factors,
                       Keys keys = Keys::shared);

}  // namespace pencil
