// The measures of error, each over all pixels of a layer. x is the image, r the reference; channels count equally.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace pencil {

/// Two images of one size, `channels` floats per pixel, interleaved.
struct PixelPair {
    const float* image = nullptr;
    const float* reference = nullptr;
    std::size_t pixels = 0;
    int channels = 3;
};

/// Undefined values are NaN, see `undefined_reason`. Equal images have the relMSE 0 and the mean ratio 1 whatever they hold.
struct Metrics {
    std::uint64_t pixels = 0;    // averaged
    std::uint64_t excluded = 0;  // because a channel of x or r is not finite
    double rmse = 0;             // sqrt(mean (x - r)^2)
    double rel_mse = 0;          // mean((x - r)^2 / (r^2 + 0.01 m^2)), m = mean(r) over pixels and channels, see relative_error.h
    double mean_ratio = 0;       // mean(x) / mean(r)
    double psnr = 0;             // -20 log10(rmse) [dB]: the peak is 1, display white; infinite for equal images
    double image_mean = 0, reference_mean = 0;
    std::optional<double> lab_rms;  // sqrt(mean dE^2), dE = distance in L*a*b* of displayed colours
};

/// `exposure`: colours are displayed as clamp(exposure * rgb, 0, 1); with it, and three channels, `lab_rms` is measured.
Metrics measure(const PixelPair& pair, const std::optional<double>& exposure = {});

/// Why values are undefined: no pixel is left to average, or those relative to the reference would be divided by its mean 0. Empty if all
/// are defined.
std::string undefined_reason(const Metrics& metrics);

}  // namespace pencil
