// Linear sRGB as one number.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

namespace pencil {

/// Rec. 709 luminance of linear sRGB.
inline double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

/// `factor` times the luminance of each pixel of linear rgb.
inline std::vector<float> scaled_luminance(const std::vector<float>& rgb, double factor) {
    std::vector<float> values(rgb.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(factor * luminance({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]}));
    return values;
}

/// Values that became infinite though the pixels of `rgb` that they were made of are finite: float's largest number instead. Returns their count.
inline std::size_t clamp_to_float(const std::vector<float>& rgb, std::vector<float>& values) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const float* pixel = &rgb[3 * i];
        if (!std::isinf(values[i]) || !std::all_of(pixel, pixel + 3, [](float v) { return std::isfinite(v); })) continue;
        values[i] = std::copysign(std::numeric_limits<float>::max(), values[i]);
        ++count;
    }
    return count;
}

}  // namespace pencil
