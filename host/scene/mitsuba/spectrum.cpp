// Tables of CIE 15: the 1931 observer every 5 nm, D65 every 10 nm (its 5 nm values are linear between these). Both are used from 380 nm
// to 780 nm. Sums every 1 nm of the piecewise linear curves. The matrix to RGB is derived from sRGB's primaries and the white point of
// the tables themselves, so that a white reflectance gives exactly (1, 1, 1).
#include "scene/mitsuba/spectrum.h"

#include <algorithm>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace pencil {
namespace {

constexpr double first_wavelength = 380.0, last_wavelength = 780.0;  // [nm]
constexpr double observer_step = 5.0, illuminant_step = 10.0;        // [nm]

// clang-format off
const glm::dvec3 observer[] = {
    {0.001368, 0.000039, 0.00645}, {0.002236, 0.000064, 0.01055}, {0.004243, 0.00012, 0.02005}, {0.00765, 0.000217, 0.03621},
    {0.01431, 0.000396, 0.06785}, {0.02319, 0.00064, 0.1102}, {0.04351, 0.00121, 0.2074}, {0.07763, 0.00218, 0.3713},
    {0.13438, 0.004, 0.6456}, {0.21477, 0.0073, 1.03905}, {0.2839, 0.0116, 1.3856}, {0.3285, 0.01684, 1.62296}, {0.34828, 0.023, 1.74706},
    {0.34806, 0.0298, 1.7826}, {0.3362, 0.038, 1.77211}, {0.3187, 0.048, 1.7441}, {0.2908, 0.06, 1.6692}, {0.2511, 0.0739, 1.5281},
    {0.19536, 0.09098, 1.28764}, {0.1421, 0.1126, 1.0419}, {0.09564, 0.13902, 0.81295}, {0.05795, 0.1693, 0.6162},
    {0.03201, 0.20802, 0.46518}, {0.0147, 0.2586, 0.3533}, {0.0049, 0.323, 0.272}, {0.0024, 0.4073, 0.2123}, {0.0093, 0.503, 0.1582},
    {0.0291, 0.6082, 0.1117}, {0.06327, 0.71, 0.07825}, {0.1096, 0.7932, 0.05725}, {0.1655, 0.862, 0.04216}, {0.22575, 0.91485, 0.02984},
    {0.2904, 0.954, 0.0203}, {0.3597, 0.9803, 0.0134}, {0.43345, 0.99495, 0.00875}, {0.51205, 1.0, 0.00575}, {0.5945, 0.995, 0.0039},
    {0.6784, 0.9786, 0.00275}, {0.7621, 0.952, 0.0021}, {0.8425, 0.9154, 0.0018}, {0.9163, 0.87, 0.00165}, {0.9786, 0.8163, 0.0014},
    {1.0263, 0.757, 0.0011}, {1.0567, 0.6949, 0.001}, {1.0622, 0.631, 0.0008}, {1.0456, 0.5668, 0.0006}, {1.0026, 0.503, 0.00034},
    {0.9384, 0.4412, 0.00024}, {0.85445, 0.381, 0.00019}, {0.7514, 0.321, 0.0001}, {0.6424, 0.265, 0.00005}, {0.5419, 0.217, 0.00003},
    {0.4479, 0.175, 0.00002}, {0.3608, 0.1382, 0.00001}, {0.2835, 0.107, 0.0}, {0.2187, 0.0816, 0.0}, {0.1649, 0.061, 0.0},
    {0.1212, 0.04458, 0.0}, {0.0874, 0.032, 0.0}, {0.0636, 0.0232, 0.0}, {0.04677, 0.017, 0.0}, {0.0329, 0.01192, 0.0},
    {0.0227, 0.00821, 0.0}, {0.01584, 0.005723, 0.0}, {0.0113592, 0.004102, 0.0}, {0.00811092, 0.002929, 0.0},
    {0.00579035, 0.002091, 0.0}, {0.00410946, 0.001484, 0.0}, {0.00289933, 0.001047, 0.0}, {0.00204919, 0.00074, 0.0},
    {0.00143997, 0.00052, 0.0}, {0.000999949, 0.0003611, 0.0}, {0.000690079, 0.0002492, 0.0}, {0.000476021, 0.0001719, 0.0},
    {0.000332301, 0.00012, 0.0}, {0.000234826, 0.0000848, 0.0}, {0.000166151, 0.00006, 0.0}, {0.000117413, 0.0000424, 0.0},
    {0.000083075, 0.00003, 0.0}, {0.000058707, 0.0000212, 0.0}, {0.00004151, 0.00001499, 0.0},
};
const double daylight[] = {
    49.9755, 54.6482, 82.7549, 91.486, 93.4318, 86.6823, 104.865, 117.008, 117.812, 114.861, 115.923, 108.811, 109.354, 107.802, 104.79,
    107.689, 104.405, 104.046, 100.0, 96.3342, 95.788, 88.6856, 90.0062, 89.5991, 87.6987, 83.2886, 83.6992, 80.0268, 80.2146, 82.2778,
    78.2842, 69.7213, 71.6091, 74.349, 61.604, 69.8856, 75.087, 63.5927, 46.4182, 66.8054, 63.3828,
};
// clang-format on

template <class T, std::size_t n>
T between(const T (&table)[n], double step, double wavelength) {
    const double position = std::clamp((wavelength - first_wavelength) / step, 0.0, static_cast<double>(n - 1));
    const std::size_t i = std::min(static_cast<std::size_t>(position), n - 2);
    const double t = position - static_cast<double>(i);
    return table[i] * (1.0 - t) + table[i + 1] * t;
}

double value_at(const SampledSpectrum& spectrum, double wavelength) {
    const std::vector<double>& w = spectrum.wavelengths;
    const auto above = std::upper_bound(w.begin(), w.end(), wavelength);
    if (above == w.begin()) return 0.0;
    const std::size_t i = static_cast<std::size_t>(above - w.begin()) - 1;
    if (above == w.end()) return wavelength == w.back() ? spectrum.values.back() : 0.0;
    const double t = (wavelength - w[i]) / (w[i + 1] - w[i]);
    return spectrum.values[i] * (1.0 - t) + spectrum.values[i + 1] * t;
}

template <class Power>
glm::dvec3 integrate_xyz(Power power) {
    glm::dvec3 sum(0.0);
    for (double wavelength = first_wavelength; wavelength <= last_wavelength; wavelength += 1.0)
        sum += power(wavelength) * cie_1931(wavelength);
    return sum;
}

glm::dvec3 white_d65() {
    const glm::dvec3 white = integrate_xyz(illuminant_d65);
    return white / white.y;
}

glm::dmat3 xyz_to_rgb() {
    const glm::dmat3 primaries(0.64, 0.33, 0.03, 0.30, 0.60, 0.10, 0.15, 0.06, 0.79);  // chromaticities of red, green, blue, IEC 61966-2-1
    const glm::dvec3 scale = glm::inverse(primaries) * white_d65();
    return glm::inverse(glm::dmat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z));
}

}  // namespace

glm::dvec3 cie_1931(double wavelength) { return between(observer, observer_step, wavelength); }

double illuminant_d65(double wavelength) { return between(daylight, illuminant_step, wavelength); }

glm::dvec3 reflectance_to_rgb(const SampledSpectrum& spectrum) {
    static const glm::dmat3 to_rgb = xyz_to_rgb();
    static const double norm = integrate_xyz(illuminant_d65).y;
    return to_rgb * (integrate_xyz([&](double w) { return illuminant_d65(w) * value_at(spectrum, w); }) / norm);
}

glm::dvec3 emission_to_rgb(const SampledSpectrum& spectrum) {
    static const glm::dmat3 to_rgb = xyz_to_rgb();
    static const double norm = integrate_xyz([](double) { return 1.0; }).y;
    return to_rgb * (integrate_xyz([&](double w) { return value_at(spectrum, w); }) / norm);
}

double srgb_to_linear(double encoded) {  // IEC 61966-2-1
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace pencil
