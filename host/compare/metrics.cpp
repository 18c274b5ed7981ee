#include "compare/metrics.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "compare/lab.h"
#include "image/relative_error.h"

namespace pencil {
namespace {

bool is_finite(const PixelPair& pair, std::size_t pixel) {
    const std::size_t first = pixel * static_cast<std::size_t>(pair.channels);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(pair.channels); ++i)
        if (!std::isfinite(pair.image[i]) || !std::isfinite(pair.reference[i])) return false;
    return true;
}

std::vector<std::size_t> finite_pixels(const PixelPair& pair) {
    std::vector<std::size_t> finite;
    finite.reserve(pair.pixels);
    for (std::size_t pixel = 0; pixel < pair.pixels; ++pixel)
        if (is_finite(pair, pixel)) finite.push_back(pixel);
    return finite;
}

/// Mean of `term(x, r)` over the channels of the pixels.
template <typename Term>
double mean_of(const PixelPair& pair, const std::vector<std::size_t>& pixels, Term term) {
    const auto channels = static_cast<std::size_t>(pair.channels);
    double sum = 0;
    for (const std::size_t pixel : pixels)
        for (std::size_t i = pixel * channels; i < (pixel + 1) * channels; ++i)
            sum += term(static_cast<double>(pair.image[i]), static_cast<double>(pair.reference[i]));
    return sum / (static_cast<double>(pixels.size()) * pair.channels);
}

glm::dvec3 displayed_lab(const float* rgb, double exposure) {
    return linear_srgb_to_lab(glm::clamp(exposure * glm::dvec3(rgb[0], rgb[1], rgb[2]), 0.0, 1.0));
}

double lab_rms(const PixelPair& pair, const std::vector<std::size_t>& pixels, double exposure) {
    double sum = 0;
    for (const std::size_t pixel : pixels) {
        const glm::dvec3 difference = displayed_lab(pair.image + 3 * pixel, exposure) - displayed_lab(pair.reference + 3 * pixel, exposure);
        sum += glm::dot(difference, difference);
    }
    return std::sqrt(sum / static_cast<double>(pixels.size()));
}

}  // namespace

Metrics measure(const PixelPair& pair, const std::optional<double>& exposure) {
    const std::vector<std::size_t> pixels = finite_pixels(pair);
    Metrics metrics;
    metrics.pixels = pixels.size();
    metrics.excluded = pair.pixels - pixels.size();
    // Without pixels every mean is 0 / 0: not a number, as it should be.
    metrics.image_mean = mean_of(
        pair, pixels, [](double x, double) { return x; });
    const double mean = metrics.reference_mean = mean_of(
        pair, pixels, [](double, double r) { return r; });
    metrics.rmse = std::sqrt(mean_of(pair, pixels, [](double x, double r) { return (x - r) * (x - r); }));
    metrics.psnr = -20 * std::log10(metrics.rmse);
    if (metrics.rmse == 0) {
        metrics.mean_ratio = 1;
    } else if (mean == 0) {
        metrics.rel_mse = metrics.mean_ratio = std::numeric_limits<double>::quiet_NaN();
    } else {
        metrics.rel_mse = mean_of(pair, pixels, [mean](double x, double r) { return relative_square(x, r, mean); });
        metrics.mean_ratio = metrics.image_mean / mean;
    }
    if (exposure && pair.channels == 3) metrics.lab_rms = lab_rms(pair, pixels, *exposure);
    return metrics;
}

std::string undefined_reason(const Metrics& metrics) {
    if (metrics.pixels == 0) return "no pixel is finite in both images";
    return std::isnan(metrics.mean_ratio) ? "the mean of the reference is 0" : "";
}

}  // namespace pencil
