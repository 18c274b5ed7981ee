#include "device/features.h"

#include <algorithm>
#include <stdexcept>

#include "device/kernel_groups.h"

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
    const KernelGroup* group = find_group(name);
    if (!group) throw std::logic_error("kernel " + name + " is in no group of kernel_groups.cpp");
    std::vector<std::string> files = {"shared/types.h",  "shared/atlas.h",          "shared/geometry.h", "shared/material.h",
                                      "shared/camera.h", "shared/surfel.h",         "shared/light.h",    "shared/film.h",
                                      "shared/bvh.h",    "shared/surface_pencil.h", "shared/weights.h",  "shared/cluster.h"};
    for (const std::string& library : group->libraries)
        files.push_back(
            "lib/" +
            (library == "weights" ? (features_.weights == PENCIL_WEIGHTS_VORONOI ? "weights_voronoi" : "weights_density") : library) +
            ".cl");
    for (const std::string& kernel : group->kernels) files.push_back(kernel + ".cl");
    return cache_.kernel(name, files, to_defines(features_, block()));
}

}  // namespace pencil
