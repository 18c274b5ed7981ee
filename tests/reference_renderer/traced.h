// Path-traced images of test scenes, and their comparison with known values in standard errors.
#pragma once

#include <cmath>
#include <string>

#include "reference/path_tracer.h"
#include "scenes/known_scenes.h"

namespace pencil::test {

constexpr double float_rounding = 1e-5;  // relative: sums of many floats, positions of corners, scene units

/// Beauty with its variance.
inline ReferenceResult trace(const Scene& scene, int spp, int max_depth = -1, std::uint64_t seed = 0) {
    ReferenceOptions options;
    options.spp = spp;
    options.max_depth = max_depth;
    options.seed = seed;
    options.variance = true;
    return trace_paths(scene, options);
}

struct Estimate {
    double mean = 0, error = 0;  // standard error
};

/// The first channel's mean over the image, its error from the variance layer; pixels are independent.
inline Estimate mean_of_image(const ReferenceResult& result) {
    const Layer &image = layer(result.layers, ""), &variance = layer(result.layers, "variance");
    const auto n = static_cast<double>(pixel_count(image));
    Estimate estimate;
    for (std::size_t i = 0; i < pixel_count(image); ++i) {
        estimate.mean += pixel(image, i).x / n;
        estimate.error += pixel(variance, i).x / (n * n);
    }
    estimate.error = std::sqrt(estimate.error);
    return estimate;
}

/// Within three standard errors, and the error is at most `precision` of the value, so that the test means something.
inline void expect_mean(const ReferenceResult& result, double expected, double precision, const std::string& what) {
    const Estimate e = mean_of_image(result);
    EXPECT_NEAR(e.mean, expected, 3.0 * e.error + float_rounding * expected) << what << ": standard error " << e.error;
    EXPECT_LE(e.error, precision * expected) << what;
}

}  // namespace pencil::test
