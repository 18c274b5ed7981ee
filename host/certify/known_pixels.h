// The certified error of images of few pixels, sensors above all: each is looked at many times, so that all looks of a pixel count together, and
// no pixel stands for others.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "options/render_result.h"

namespace pencil {

/// Independent unbiased estimates of a pixel, summed: of their steps from its value x, and of the squares of these.
struct PixelLooks {
    int count = 0;
    glm::dvec3 steps{0.0}, squares{0.0};
    void add(const glm::dvec3& step) {
        ++count;
        steps += step;
        squares += step * step;
    }
};

/// The mean over all pairs of estimates of the product of their steps is (x - m)^2, m the truth: ((sum d)^2 - sum d^2) / (n (n - 1)).
/// `looks`, `shown`: by pixel, those with fewer than two looks are left out; rgb of `shown` decides what errors are relative to; `mean`: of the
/// image.
CertifiedError certify_pixels(const std::vector<PixelLooks>& looks, const std::vector<float>& shown, double mean);

}  // namespace pencil
