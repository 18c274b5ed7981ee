#include "device/kernel_groups.h"

#include <algorithm>

namespace pencil {

namespace {

const std::vector<KernelGroup>& groups() {
    static const std::vector<KernelGroup> all{
        // Film: every render.
        {{"packet", "octahedral", "triangle", "raster", "brdf_diffuse", "brdf", "surfel"},
         {"bound_film", "rasterize_film", "classify_film", "film_surfels", "emit_surfels", "resolve_film"}},
        // Geometry maps, and direct light through them.
        {{"packet", "hash", "octahedral", "triangle", "raster", "octant", "footprint", "brdf_diffuse", "brdf", "surfel_packet", "bvh",
          "visibility", "packet_visibility", "light_sample"},
         {"rasterize_octahedral", "rasterize_clusters", "trace_octahedral", "fold_hits", "light_surfels", "sample_lights"}},
        // Line projection.
        {{"packet", "octahedral", "triangle", "brdf_diffuse", "brdf", "surfel", "footprint", "surfel_packet", "bvh", "visibility",
          "packet_visibility", "projection", "weights"},
         {"find_enclosing", "find_sides", "gather_surfels", "test_visibility", "estimate_density", "free_path_density", "project_pencils",
          "store_radiance", "smooth_radiance", "sum_radiance"}},
        // Rays that find places for pencils.
        {{"packet", "triangle", "brdf_diffuse", "brdf", "surfel", "bvh"}, {"trace_probing_rays"}},
        // Surface pencils.
        {{"packet", "hash", "triangle", "brdf_diffuse", "brdf", "surfel", "bvh", "hemisphere", "surface_pencil", "pencil_grid",
          "film_lattice"},
         {"place_surface_pencils", "trace_hemispheres", "measure_hemispheres", "emit_hemispheres", "sum_hemispheres",
          "project_surface_pencils", "link_surfels", "transport_irradiance", "close_series", "cover_film", "smooth_irradiance",
          "project_film_pencils"}},
    };
    return all;
}

}  // namespace

const KernelGroup* find_group(const std::string& kernel) {
    for (const KernelGroup& group : groups())
        if (std::find(group.kernels.begin(), group.kernels.end(), kernel) != group.kernels.end()) return &group;
    return nullptr;
}

}  // namespace pencil
