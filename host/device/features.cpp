#include "device/features.h"

#include <algorithm>

#include "cl/kernel_source.h"

namespace pencil {

Features scene_features(const FlatScene& scene, int film_samples) {
    Features features;
    features.smooth = !scene.normals.empty();
    features.film_samples = film_samples;
    features.outgoing = std::any_of(scene.materials.begin(), scene.materials.end(),
                                    [](const Material& material) { return material.model != MATERIAL_DIFFUSE; });
    return features;
}

Defines to_defines(const Features& features, int block) {
    return {{"PENCIL_SMOOTH", features.smooth ? "1" : "0"},
            {"PENCIL_OUTGOING", features.outgoing ? "1" : "0"},
            {"PENCIL_WEIGHTS", std::to_string(features.weights)},
            {"PENCIL_CELL_GRID", std::to_string(features.cell_grid)},
            {"PENCIL_BVH", features.bvh ? "1" : "0"},
            {"PENCIL_BLOCK", std::to_string(block)},
            {"PENCIL_FILM_SAMPLES", std::to_string(features.film_samples)}};
}

Launch Kernels::get(const std::string& name) {
    if (before_launch_) before_launch_();
    return cache_.kernel(name, program_of(name), to_defines(features_, block()));
}

}  // namespace pencil
