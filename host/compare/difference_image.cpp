#include "compare/difference_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "image/colour.h"
#include "image/relative_error.h"
#include "image/write_image.h"

namespace pencil {
namespace {

constexpr double covered_share = 0.99;  // of the pixels stay below the scale

using Colour = std::array<float, 3>;  // sRGB display values

/// Diverging scale of five colours, from blue over white to red (ColorBrewer RdBu; told apart with red-green blindness, too).
constexpr std::array<Colour, 5> diverging{
    {{0.020F, 0.188F, 0.380F}, {0.263F, 0.576F, 0.765F}, {0.969F, 0.969F, 0.969F}, {0.839F, 0.376F, 0.302F}, {0.404F, 0.000F, 0.122F}}};
constexpr Colour undefined_colour{1.0F, 0.9F, 0.0F};

/// `position` in [-1, 1].
Colour colour_at(double position) {
    const double along = (position + 1) / 2 * (diverging.size() - 1);
    const std::size_t stop = std::min(static_cast<std::size_t>(along), diverging.size() - 2);
    const float fraction = static_cast<float>(along - static_cast<double>(stop));
    Colour colour;
    for (std::size_t c = 0; c < colour.size(); ++c)
        colour[c] = diverging[stop][c] + fraction * (diverging[stop + 1][c] - diverging[stop][c]);
    return colour;
}

double pixel_luminance(const float* rgb, std::size_t pixel) { return luminance({rgb[3 * pixel], rgb[3 * pixel + 1], rgb[3 * pixel + 2]}); }

double mean_luminance(const float* rgb, std::size_t pixels) {
    double sum = 0;
    std::size_t finite = 0;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const double y = pixel_luminance(rgb, pixel);
        if (std::isfinite(y)) {
            sum += y;
            ++finite;
        }
    }
    return finite > 0 ? sum / static_cast<double>(finite) : 0;
}

}  // namespace

std::vector<float> relative_difference(const float* image, const float* reference, std::size_t pixels) {
    const double mean = mean_luminance(reference, pixels);
    std::vector<float> differences(pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const double x = pixel_luminance(image, pixel), r = pixel_luminance(reference, pixel);
        if (!std::isfinite(x) || !std::isfinite(r))
            differences[pixel] = std::numeric_limits<float>::quiet_NaN();
        else if (x != r)
            differences[pixel] = static_cast<float>(std::copysign(std::sqrt(relative_square(x, r, mean)), x - r));
    }
    return differences;
}

double difference_scale(std::vector<float> differences) {
    differences.erase(std::remove_if(differences.begin(), differences.end(), [](float d) { return std::isnan(d); }), differences.end());
    if (differences.empty()) return 1;
    const auto magnitude = [](float a, float b) { return std::abs(a) < std::abs(b); };
    const auto last = std::min(differences.size() - 1, static_cast<std::size_t>(covered_share * static_cast<double>(differences.size())));
    std::nth_element(differences.begin(), differences.begin() + static_cast<std::ptrdiff_t>(last), differences.end(), magnitude);
    const double covered = std::abs(differences[last]);
    const double finest = 1e-6;  // equal images have no scale of their own
    for (double power = finest; power < 1; power *= 10) {
        for (const double step : {1.0, 2.0, 5.0})
            if (covered <= step * power) return step * power;
    }
    return 1;
}

std::vector<float> false_colour(const std::vector<float>& differences, double scale) {
    std::vector<float> rgb;
    rgb.reserve(3 * differences.size());
    for (const float difference : differences) {
        const Colour colour = std::isnan(difference) ? undefined_colour : colour_at(std::clamp(difference / scale, -1.0, 1.0));
        std::transform(colour.begin(), colour.end(), std::back_inserter(rgb), srgb_to_linear);
    }
    return rgb;
}

}  // namespace pencil
