// Where and in which direction an image differs from its reference, in false colours.
#pragma once

#include <cstddef>
#include <vector>

namespace pencil {

/// Signed relative error of the luminance per pixel: (x - r) / sqrt(r^2 + 0.01 m^2), m the mean luminance of the reference; the square
/// is a pixel's part of relMSE. NaN where a value is not finite, 0 everywhere for a black reference that the image equals. Both images
/// are linear rgb.
std::vector<float> relative_difference(const float* image, const float* reference, std::size_t pixels);

/// A round number (1, 2 or 5 times a power of ten, at most 1) that the magnitude of 99 % of the pixels does not exceed.
double difference_scale(std::vector<float> differences);

/// Display values as linear rgb: white 0, red +scale and more (the image is too bright), blue -scale and less (too dark), yellow for NaN.
std::vector<float> false_colour(const std::vector<float>& differences, double scale);

}  // namespace pencil
