#include "compare/lab.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <vector>

#include "image/colour.h"

namespace pencil {
namespace {

constexpr double middle_grey = 0.18;

/// Linear sRGB to CIE XYZ (IEC 61966-2-1, D65), columns for R, G, B. The white point is the sum of the columns.
const glm::dmat3 to_xyz(0.4124564, 0.2126729, 0.0193339, 0.3575761, 0.7151522, 0.1191920, 0.1804375, 0.0721750, 0.9503041);

/// CIE 15:2004 (8.5): the cube root, linear below (6/29)^3.
double compress(double ratio) {
    const double delta = 6.0 / 29.0;
    return ratio > delta * delta * delta ? std::cbrt(ratio) : ratio / (3 * delta * delta) + 4.0 / 29.0;
}

}  // namespace

glm::dvec3 linear_srgb_to_lab(const glm::dvec3& rgb) {
    const glm::dvec3 xyz = (to_xyz * rgb) / (to_xyz * glm::dvec3(1.0));
    const double x = compress(xyz.x), y = compress(xyz.y), z = compress(xyz.z);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double exposure_of(const float* rgb, std::size_t pixels) {
    std::vector<double> lit;
    for (std::size_t i = 0; i < pixels; ++i) {
        const double y = luminance({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]});
        if (std::isfinite(y) && y > 0) lit.push_back(y);
    }
    if (lit.empty()) return 1;
    const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
    std::nth_element(lit.begin(), middle, lit.end());
    return middle_grey / *middle;
}

}  // namespace pencil
