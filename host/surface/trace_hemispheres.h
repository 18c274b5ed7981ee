// Launcher of kernels/trace_hemispheres.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Which points of their texels pencils see.
struct TexelPoints {
    uint seed = 0;
    uint turn = 0;  // points of one seed and key in successive turns fill each texel evenly
};

/// Operator Q for hemispheres: surfels, from first_surfel on, that the texels of pencils first .. first + count see, n x n per pencil.
/// surfels.count becomes the end of them; they must have room. The scene must have its hierarchy. `map`: pencils share maps of this width,
/// each has n x n texels of one; 0: each has its own.
void trace_hemispheres(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count,
                       const TexelPoints& points, Surfels& surfels, int first_surfel = 0, int map = 0);

}  // namespace pencil
