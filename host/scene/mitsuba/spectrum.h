// Spectra to linear sRGB, through the CIE 1931 2-degree observer. Used for reflectances and for emission, which differ in the illuminant.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace pencil {

/// One value per wavelength [nm], wavelengths increasing; linear between them and zero outside them, as in Mitsuba.
struct SampledSpectrum {
    std::vector<double> wavelengths;
    std::vector<double> values;
};

/// The colour under illuminant D65, scaled so that reflectance 1 at all wavelengths is (1, 1, 1). May leave [0, 1]: not clamped.
glm::dvec3 reflectance_to_rgb(const SampledSpectrum& spectrum);

/// The light's own colour, scaled so that 1 at all wavelengths (illuminant E) has luminance Y = 1. May be negative: not clamped.
glm::dvec3 emission_to_rgb(const SampledSpectrum& spectrum);

/// One value of sRGB's transfer curve, undone.
double srgb_to_linear(double encoded);

/// CIE 1931 xyz and D65 between the tabulated points, for tests.
glm::dvec3 cie_1931(double wavelength);
double illuminant_d65(double wavelength);

}  // namespace pencil
