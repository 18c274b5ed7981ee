// Distribution and zenith values: appendix A.2; attenuation of the sun: appendix A.1, with the sun as a black body of 5778 K and ozone as one
// band (Chappuis) instead of tables.
#include "scene/mitsuba/preetham.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "scene/mitsuba/spectrum.h"
#include "util/constants.h"

namespace pencil {
namespace {

constexpr double luminous_efficacy = 683.0;     // [lm/W]
constexpr double luminosity_width = 106.85698;  // integral of the eye's sensitivity [nm]

/// 1 + a e^(b / cos(theta)), times 1 + c e^(d gamma) + e cos^2(gamma)
glm::dvec3 perez(const glm::dvec3 (&k)[5], double cos_theta, double gamma) {
    const double cos_gamma = std::cos(gamma);
    return (1.0 + k[0] * glm::exp(k[1] / std::max(cos_theta, 0.01))) * (1.0 + k[2] * glm::exp(k[3] * gamma) + k[4] * cos_gamma * cos_gamma);
}

glm::dvec3 to_rgb(double x, double y, double luminance) {
    const glm::dvec3 xyz(luminance * x / y, luminance, luminance * (1 - x - y) / y);
    // IEC 61966-2-1
    return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z, -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
            0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

}  // namespace

PreethamSky::PreethamSky(const glm::dvec3& to_sun, double turbidity) : to_sun_(to_sun), turbidity_(turbidity) {
    const double t = turbidity, s = std::acos(std::clamp(to_sun.y, 0.0, 1.0));
    const double chi = (4.0 / 9.0 - t / 120.0) * (pi - 2.0 * s);
    const glm::dvec4 angles(s * s * s, s * s, s, 1.0);
    const auto chromaticity = [&](const glm::dvec4& t2, const glm::dvec4& t1, const glm::dvec4& t0) {
        return t * t * glm::dot(angles, t2) + t * glm::dot(angles, t1) + glm::dot(angles, t0);
    };
    zenith_.x =
        chromaticity({0.00166, -0.00375, 0.00209, 0.0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886});
    zenith_.y =
        chromaticity({0.00275, -0.00610, 0.00317, 0.0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688});
    zenith_.z = std::max((4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192, 0.0);
    coefficients_[0] = {-0.0193 * t - 0.2592, -0.0167 * t - 0.2608, 0.1787 * t - 1.4630};
    coefficients_[1] = {-0.0665 * t + 0.0008, -0.0950 * t + 0.0092, -0.3554 * t + 0.4275};
    coefficients_[2] = {-0.0004 * t + 0.2125, -0.0079 * t + 0.2102, -0.0227 * t + 5.3251};
    coefficients_[3] = {-0.0641 * t - 0.8989, -0.0441 * t - 1.6537, 0.1206 * t - 2.5771};
    coefficients_[4] = {-0.0033 * t + 0.0452, -0.0109 * t + 0.0529, -0.0670 * t + 0.3703};
    perez_of_sun_ = perez(coefficients_, 1.0, s);
}

glm::dvec3 PreethamSky::radiance(const glm::dvec3& direction) const {
    const double gamma = std::acos(std::clamp(glm::dot(direction, to_sun_), -1.0, 1.0));
    const glm::dvec3 value = zenith_ * perez(coefficients_, direction.y, gamma) / perez_of_sun_;
    const double luminance = value.z * 1000.0 / (luminous_efficacy * luminosity_width);
    return glm::max(to_rgb(value.x, value.y, luminance), glm::dvec3(0.0));
}

glm::dvec3 PreethamSky::sun_irradiance() const {
    constexpr double solid_angle = 6.807e-5, kelvin = 5778.0;  // of the sun's disc [sr], of its surface
    constexpr double h = 6.62607015e-34, c = 299792458.0, k = 1.380649e-23;
    if (to_sun_.y <= 0) return glm::dvec3(0.0);
    const double degrees = std::acos(std::min(to_sun_.y, 1.0)) * 180.0 / pi;
    const double mass = 1.0 / (to_sun_.y + 0.15 * std::pow(93.885 - degrees, -1.253));
    const double haze = 0.04608365822050 * turbidity_ - 0.04586025928522;
    SampledSpectrum spectrum;
    for (double nanometres = 360; nanometres <= 830; nanometres += 5) {
        const double metres = nanometres * 1e-9, micrometres = nanometres * 1e-3;
        const double rayleigh = std::exp(-mass * 0.008735 * std::pow(micrometres, -4.08));
        const double aerosol = std::exp(-mass * haze * std::pow(micrometres, -1.3));
        const double band = (nanometres - 600.0) / 70.0;  // ozone absorbs 12 % per centimetre around 600 nm; there are 0.35 cm of it
        const double ozone = std::exp(-mass * 0.35 * 0.12 * std::exp(-band * band));
        const double outside = 2.0 * h * c * c / (std::pow(metres, 5.0) * std::expm1(h * c / (metres * k * kelvin))) * 1e-9;
        spectrum.wavelengths.push_back(nanometres);
        spectrum.values.push_back(outside * rayleigh * aerosol * ozone * solid_angle);
    }
    return glm::max(emission_to_rgb(spectrum), glm::dvec3(0.0));
}

}  // namespace pencil
