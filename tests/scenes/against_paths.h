// Images of the surface method against the path tracer's.
#pragma once

#include "reference/path_tracer.h"
#include "scenes/scene_builder.h"

namespace pencil::test {

/// Side of the images [pixels].
constexpr int compared_size = 24;

inline RenderOptions compared_options() {
    RenderOptions options;
    options.method = MethodName::surface;
    options.pencils = 200;
    options.width = options.height = compared_size;
    options.film_samples = 8;
    options.target_error = 2e-3;
    options.aovs = {};
    return options;
}

inline dvec3 mean_radiance(const Layer& image) {
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < pixel_count(image); ++i) sum += pixel(image, i);
    return sum / static_cast<double>(pixel_count(image));
}

/// Mean radiance within `bound` of the path tracer's, channel by channel.
inline void expect_path_tracers(const Scene& scene, double bound, int spp = 1024, double target_error = 2e-3) {
    ReferenceOptions reference;
    reference.spp = spp;
    reference.width = reference.height = compared_size;
    const dvec3 truth = mean_radiance(trace_paths(scene, reference).layers.front());
    RenderOptions options = compared_options();
    options.target_error = target_error;
    const RenderResult result = render_layers(scene, options);
    const dvec3 ratio = mean_radiance(layer(result, "")) / truth;
    std::printf("surface method over path tracer: %.4f %.4f %.4f, %d passes\n", ratio.x, ratio.y, ratio.z, result.stats.passes);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, bound) << "channel " << c;
}

}  // namespace pencil::test
