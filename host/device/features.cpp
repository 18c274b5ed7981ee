#include "device/features.h"

#include <algorithm>

#include "cl/kernel_source.h"
#include "shared/surfel.h"

namespace pencil {

Features scene_features(const FlatScene& scene, int film_samples, bool lobes) {
    Features features;
    features.smooth = !scene.normals.empty();
    features.film_samples = film_samples;
    const bool textured = features.textures = !scene.textures.empty();
    for (const Material& material : scene.materials) {
        features.models.insert(material.model);
        features.blends = features.blends || material.model == MATERIAL_BLEND || material.back >= 0;
        features.clear = features.clear || (lobes && (material.flags & MATERIAL_CLEAR) != 0);
        features.relief = features.relief || (textured && material.normal_texture >= 0);
        features.glow = features.glow || (textured && material.emission_texture >= 0);
        const bool even = material.model == MATERIAL_DIFFUSE || material.model == MATERIAL_BLEND;
        features.lobes = features.lobes || (lobes && !even);
    }
    features.wide_camera = scene.is_wide_camera();
    features.sky = scene.sky.width > 0;
    features.far_light = features.sky || scene.far_light;
    return features;
}

int Features::surfel_fields() const { return glow ? SURFEL_FIELDS_GLOW : outgoing() ? SURFEL_FIELDS_OUTGOING : SURFEL_FIELDS; }

/// Names and numbers of the models that kernels may leave out.
const std::vector<std::pair<std::string, int>>& optional_models() {
#define MODEL_PAIR(NAME, name) {#NAME, MATERIAL_##NAME},
    static const std::vector<std::pair<std::string, int>> models{MATERIAL_MODELS(MODEL_PAIR)};
#undef MODEL_PAIR
    return models;
}

Defines to_defines(const Features& features, int block) {
    Defines defines{{"PENCIL_SMOOTH", features.smooth ? "1" : "0"},
                    {"PENCIL_OUTGOING", features.outgoing() ? "1" : "0"},
                    {"PENCIL_LOBES", features.lobes ? "1" : "0"},
                    {"PENCIL_WIDE_CAMERA", features.wide_camera ? "1" : "0"},
                    {"PENCIL_FAR_LIGHT", features.far_light ? "1" : "0"},
                    {"PENCIL_SKY", features.sky ? "1" : "0"},
                    {"PENCIL_BLENDS", features.blends ? "1" : "0"},
                    {"PENCIL_TEXTURES", features.textures ? "1" : "0"},
                    {"PENCIL_CLEAR", features.clear ? "1" : "0"},
                    {"PENCIL_RELIEF", features.relief ? "1" : "0"},
                    {"PENCIL_GLOW", features.glow ? "1" : "0"},
                    {"PENCIL_WEIGHTS", std::to_string(features.weights)},
                    {"PENCIL_CELL_GRID", std::to_string(features.cell_grid)},
                    {"PENCIL_MAP_KIND", std::to_string(features.map_kind)},
                    {"PENCIL_ATLAS_IMAGE", features.atlas_image ? "1" : "0"},
                    {"PENCIL_WIDE_BVH", features.wide_bvh ? "1" : "0"},
                    {"PENCIL_BVH", features.bvh ? "1" : "0"},
                    {"PENCIL_BLOCK", std::to_string(block)},
                    {"PENCIL_FILM_SAMPLES", std::to_string(features.film_samples)}};
    for (const auto& [name, model] : optional_models()) defines["PENCIL_MODEL_" + name] = features.models.count(model) > 0 ? "1" : "0";
    return defines;
}

void Kernels::build_ahead(const std::vector<SureKernel>& sure) {
    std::vector<KernelBuild> builds;
    builds.reserve(sure.size());
    for (const SureKernel& kernel : sure) builds.push_back({kernel.name, kernel.items, to_defines(features_, block())});
    ahead_ = std::make_unique<BuildAhead>(*device(), builds);
}

Launch Kernels::get(const std::string& name) {
    if (before_launch_) before_launch_();
    return cache_.kernel(name, program_of(name), to_defines(features_, block()));
}

}  // namespace pencil
