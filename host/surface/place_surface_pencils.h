// Launcher of kernels/place_surface_pencils.cl.
#pragma once

#include <glm/vec3.hpp>

#include "device/features.h"
#include "device/surfels.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Surfels that pencils are placed on.
struct ChosenSurfels {
    /// `viewer`: where the surfel was seen from; `radius`: how far the pencil may be used through a grid [scene units].
    void add(int surfel, uint key, const glm::vec3& viewer, float radius = 0) {
        surfels.push_back(surfel);
        keys.push_back(key);
        views.emplace_back(viewer, radius);
    }
    std::vector<int> surfels;
    std::vector<uint> keys;     // SurfacePencil.key
    std::vector<float4> views;  // xyz: viewer; w: radius
};

/// Appends a pencil for each chosen surfel; `spacing`: of the lattice of film pencils that they join [pixels], 0: none.
void place_surface_pencils(Kernels& kernels, const Surfels& surfels, const ChosenSurfels& chosen, SurfacePencils& pencils, int spacing = 0);

}  // namespace pencil
