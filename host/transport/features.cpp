#include "transport/features.h"

#include <stdexcept>

#include "transport/kernel_groups.h"

namespace pencil {

Features detect_features(const FlatScene& scene, bool thesis_weights, int film_samples, bool bvh) {
    Features features;
    features.smooth = !scene.normals.empty();
    features.thesis_weights = thesis_weights;
    features.film_samples = film_samples;
    features.bvh = bvh;
    return features;
}

Defines to_defines(const Features& features, int block) {
    return {{"PENCIL_SMOOTH", features.smooth ? "1" : "0"},
            {"PENCIL_WEIGHTS_THESIS", features.thesis_weights ? "1" : "0"},
            {"PENCIL_BVH", features.bvh ? "1" : "0"},
            {"PENCIL_BLOCK", std::to_string(block)},
            {"PENCIL_FILM_SAMPLES", std::to_string(features.film_samples)}};
}

Launch Kernels::get(const std::string& name) {
    const KernelGroup* group = find_group(name);
    if (!group) throw std::logic_error("kernel " + name + " is in no group of kernel_groups.cpp");
    std::vector<std::string> files = {"shared/types.h", "shared/atlas.h", "shared/geometry.h", "shared/camera.h",        "shared/surfel.h",
                                      "shared/light.h", "shared/film.h",  "shared/bvh.h",      "shared/surface_pencil.h"};
    for (const std::string& library : group->libraries) files.push_back("lib/" + library + ".cl");
    for (const std::string& kernel : group->kernels) files.push_back(kernel + ".cl");
    return cache_.kernel(name, files, to_defines(features_, block()));
}

}  // namespace pencil
