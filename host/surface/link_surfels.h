// Launcher of kernels/link_surfels.cl.
#pragma once

#include <tuple>

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "surface/pencil_grid.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// The pencils near each surfel, at most four, and their weights, which sum to 1.
struct SurfaceLinks {
    /// Arguments `links, factors` of kernels.
    auto list() const { return std::tie(pencils, weights); }

    Buffer<glm::ivec4> pencils;  // -1: none; LINK_STANDS_IN behind a pencil that stands there only because no other does
    Buffer<float4> weights;
};

/// Operator R on the world set, for surfels that are lit again and again. The scene must have its hierarchy.
SurfaceLinks link_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const SurfacePencils& pencils,
                          const DeviceGrid& grid);

}  // namespace pencil
