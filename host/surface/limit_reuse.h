// Launcher of kernels/limit_reuse.cl.
#pragma once

#include "device/features.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Limits how far the pencils of a lattice may be used by their neighbours at `spacing`; those from first_new on were not limited before.
void limit_reuse(Kernels& kernels, SurfacePencils& pencils, const Buffer<int>& pencil_at, int spacing, int first_new, int width,
                 int height);

}  // namespace pencil
