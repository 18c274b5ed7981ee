#include "device/features.h"

#include <stdexcept>

#include "device/kernel_groups.h"
#include "line/weights.h"

namespace pencil {

Features detect_features(const FlatScene& scene, const RenderOptions& options) {
    Features features;
    features.smooth = !scene.normals.empty();
    if (options.method == Method::line) features.weights = options.weights;
    features.cell_grid = features.weights == Weights::voronoi ? largest_cell_grid(options.pencils) : 0;
    features.bvh = options.method == Method::surface;
    features.film_samples = options.film_samples;
    return features;
}

Defines to_defines(const Features& features, int block) {
    return {{"PENCIL_SMOOTH", features.smooth ? "1" : "0"},
            {"PENCIL_WEIGHTS", std::to_string(kernel_weights(features.weights))},
            {"PENCIL_CELL_GRID", std::to_string(features.cell_grid)},
            {"PENCIL_BVH", features.bvh ? "1" : "0"},
            {"PENCIL_BLOCK", std::to_string(block)},
            {"PENCIL_FILM_SAMPLES", std::to_string(features.film_samples)}};
}

Launch Kernels::get(const std::string& name) {
    const KernelGroup* group = find_group(name);
    if (!group) throw std::logic_error("kernel " + name + " is in no group of kernel_groups.cpp");
    std::vector<std::string> files = {"shared/types.h",          "shared/atlas.h",   "shared/geometry.h", "shared/camera.h",
                                      "shared/surfel.h",         "shared/light.h",   "shared/film.h",     "shared/bvh.h",
                                      "shared/surface_pencil.h", "shared/weights.h", "shared/cluster.h"};
    for (const std::string& library : group->libraries)
        files.push_back("lib/" + (library == "weights" ? weights_library(features_.weights) : library) + ".cl");
    for (const std::string& kernel : group->kernels) files.push_back(kernel + ".cl");
    return cache_.kernel(name, files, to_defines(features_, block()));
}

}  // namespace pencil
