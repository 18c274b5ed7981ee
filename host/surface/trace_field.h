// Launcher of kernels/trace_field.cl.
#pragma once

#include <glm/vec2.hpp>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "surface/surface_pencils.h"
#include "surface/trace_hemispheres.h"

namespace pencil {

/// Operator Q for pencils in free space: the surfels that the texels of octahedral maps of pencils first .. first + count see, n x n each, from
/// surfel 0 on; position and key of the pencils count. surfels.count becomes the end of them; they must have room. The scene must have its
/// hierarchy.
void trace_field(Kernels& kernels, const DeviceScene& scene, const SurfacePencils& pencils, int first, int count, const TexelPoints& points,
                 Surfels& surfels);

/// Texel of entry i of a map of n x n: oct_block_texel of kernels/lib/octahedral.cl.
glm::ivec2 field_texel(int i, int n);

}  // namespace pencil
