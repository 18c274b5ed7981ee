#include "surface/surface_needs.h"

#include <algorithm>

namespace pencil {

MethodNeeds surface_needs(const Scene& scene, const std::vector<LightForm>&, const RenderOptions& options) {
    const auto pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
    MethodNeeds needs;
    needs.kernels = {{"sample_lights"},
                     {"trace_hemispheres"},
                     {"trace_checks"},
                     {"place_surface_pencils"},
                     {"measure_hemispheres"},
                     {"link_surfels"},
                     {"link_surfels", texels_of_set},
                     {"emit_hemispheres", texels_of_set},
                     {"sum_hemispheres"},
                     {"transport_irradiance"},
                     {"close_series"},
                     {"approach_emitters"},
                     {"project_surface_pencils", pixels},
                     {"project_contacts"},
                     {"limit_reuse", pixels},
                     {"cover_film", pixels},
                     {"smooth_irradiance", pixels},
                     {"project_film_pencils", pixels}};
    const bool lobes = std::any_of(scene.materials.begin(), scene.materials.end(), [](const SceneMaterial& material) {
        return material.model != MATERIAL_DIFFUSE && material.model != MATERIAL_BLEND;
    });
    if (lobes)
        for (const char* kernel : {"emit_chains", "add_reflections", "light_lobes", "follow_surfels"})
            needs.kernels.push_back({kernel, pixels});
    needs.hierarchy = needs.rays_for_visibility = needs.lobes = true;
    return needs;
}

}  // namespace pencil
