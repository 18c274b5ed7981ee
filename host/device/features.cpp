#include "device/features.h"

#include <algorithm>

#include "cl/kernel_source.h"

namespace pencil {

Features scene_features(const FlatScene& scene, int film_samples) {
    Features features;
    features.smooth = !scene.normals.empty();
    features.film_samples = film_samples;
    for (const Material& material : scene.materials) features.models.insert(material.model);
    features.outgoing = std::any_of(features.models.begin(), features.models.end(), [](int model) { return model != MATERIAL_DIFFUSE; });
    return features;
}

/// Names and numbers of the models that kernels may leave out.
const std::vector<std::pair<std::string, int>>& optional_models() {
#define MODEL_PAIR(NAME, name) {#NAME, MATERIAL_##NAME},
    static const std::vector<std::pair<std::string, int>> models{MATERIAL_MODELS(MODEL_PAIR)};
#undef MODEL_PAIR
    return models;
}

Defines to_defines(const Features& features, int block) {
    Defines defines{{"PENCIL_SMOOTH", features.smooth ? "1" : "0"},
                    {"PENCIL_OUTGOING", features.outgoing ? "1" : "0"},
                    {"PENCIL_WEIGHTS", std::to_string(features.weights)},
                    {"PENCIL_CELL_GRID", std::to_string(features.cell_grid)},
                    {"PENCIL_BVH", features.bvh ? "1" : "0"},
                    {"PENCIL_BLOCK", std::to_string(block)},
                    {"PENCIL_FILM_SAMPLES", std::to_string(features.film_samples)}};
    for (const auto& [name, model] : optional_models()) defines["PENCIL_MODEL_" + name] = features.models.count(model) > 0 ? "1" : "0";
    return defines;
}

Launch Kernels::get(const std::string& name) {
    if (before_launch_) before_launch_();
    return cache_.kernel(name, program_of(name), to_defines(features_, block()));
}

}  // namespace pencil
