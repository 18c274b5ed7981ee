// Launcher of kernels/approach_emitters.cl.
#pragma once

#include "device/device_scene.h"
#include "device/surfels.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Limits how far pencils first .. first + count, whose texels are surfels 0 .., may be used by how near the emitters are that they see;
/// near_area: of the light samples (emit_hemispheres.h).
void approach_emitters(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, int first, int count,
                       const Buffer<float>& near_area, SurfacePencils& pencils);

}  // namespace pencil
