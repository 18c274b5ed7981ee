// Spectra as wavelengths and values: written out, in a file of their own, as a plugin, or a black body's.
#pragma once

#include <optional>

#include "scene/mitsuba/spectrum.h"
#include "scene/mitsuba/xml_source.h"

namespace pencil {

/// True if the element's value is a curve over wavelength, which parse_spectrum() reads.
bool is_sampled(pugi::xml_node node);

/// Plugins that are one number for all colours: "uniform", and "d65", whose white is sRGB's own.
std::optional<double> parse_grey_spectrum(XmlSource& source, pugi::xml_node node);

/// Not checked: wavelengths may fall, values may be negative.
SampledSpectrum parse_spectrum(XmlSource& source, pugi::xml_node node);

/// What one token of a value says.
double token_number(const XmlSource& source, pugi::xml_node node, std::string_view token);

}  // namespace pencil
