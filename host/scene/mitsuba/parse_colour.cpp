// Colours: numbers as they are, hexadecimal and sRGB codes decoded, spectra integrated. Reflectances are cut to [0, 1].
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include "scene/mitsuba/parse_spectrum.h"
#include "scene/mitsuba/xml_values.h"
#include "scene/text.h"

namespace pencil {
namespace {

/// "#rrggbb": code values over 255. Mitsuba 0.x takes them as linear in <rgb> and as encoded in <srgb>.
std::optional<glm::dvec3> parse_hex(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    glm::dvec3 colour(0.0);
    for (int i = 0; i < 6; ++i) {
        const char* digits = "0123456789abcdef";
        const char c = text[static_cast<std::size_t>(i) + 1];
        const char* digit = std::strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c);
        if (!digit || c == '\0') return std::nullopt;
        colour[i / 2] = colour[i / 2] * 16.0 + static_cast<double>(digit - digits);
    }
    return colour / 255.0;
}

/// What Mitsuba refuses, too, with what is meant. `text` has no form that is known.
[[noreturn]] void fail_for_form(const XmlSource& source, pugi::xml_node node, const std::string& text, std::size_t count) {
    const std::string tag = std::string("<") + node.name() + "> ", digits = text.substr(std::min<std::size_t>(text.size(), 1));
    const std::string no_opacity = "a colour has no opacity: leave out the last, and put the bsdf into one of type \"mask\"";
    if (count == 1 && digits.size() == 8)
        source.fail(node, tag + in_quotes(text) + " has four parts; write " + in_quotes(text.substr(0, 7)) + ", since " + no_opacity);
    if (count == 1 && digits.size() == 3) {
        std::string full = "#";
        for (const char c : digits) full += std::string(2, c);
        source.fail(node, tag + in_quotes(text) + " is too short for a colour; write " + in_quotes(full));
    }
    if (count == 1) source.fail(node, tag + in_quotes(text) + " is not a colour of the form \"#rrggbb\"");
    source.fail(node, tag + in_quotes(text) + " has " + std::to_string(count) + " numbers, not one or three" +
                          (count == 4 ? "; " + no_opacity : ""));
}

void check_samples(XmlSource& source, pugi::xml_node node, const SampledSpectrum& spectrum, bool reflects) {
    bool too_bright = false;
    if (spectrum.values.size() < 2) source.fail(node, "a sampled spectrum needs at least two wavelength:value pairs");
    for (std::size_t i = 0; i < spectrum.values.size(); ++i) {
        if (i > 0 && spectrum.wavelengths[i] <= spectrum.wavelengths[i - 1])
            source.fail(node, "the wavelengths of a spectrum must increase");
        if (spectrum.values[i] < 0.0) source.fail(node, "a spectrum must not be negative");
        too_bright = too_bright || (reflects && spectrum.values[i] > 1.0);
    }
    if (too_bright) source.approximate(node, "a reflectance spectrum must not exceed 1: its colour is cut to 1");
}

glm::dvec3 parse_sampled(XmlSource& source, pugi::xml_node node, ColourUse use) {
    const SampledSpectrum spectrum = parse_spectrum(source, node);
    const bool reflects = use == ColourUse::reflectance;
    check_samples(source, node, spectrum, reflects);
    const glm::dvec3 colour = use == ColourUse::emission ? emission_to_rgb(spectrum) : reflectance_to_rgb(spectrum);
    const glm::dvec3 inside = glm::clamp(colour, glm::dvec3(0.0), glm::dvec3(reflects ? 1.0 : HUGE_VAL));
    constexpr double noticeable = 1e-3;  // below it the cut is rounding
    if (glm::any(glm::greaterThan(glm::abs(colour - inside), glm::dvec3(noticeable * std::max(1.0, colour.y)))))
        source.warn(node, "the spectrum's colour lies outside sRGB; cut to the nearest representable components");
    return inside;
}

/// Emission of 1 at all wavelengths: illuminant E, which is redder than sRGB's white.
glm::dvec3 uniform_emission() { return emission_to_rgb({{360.0, 830.0}, {1.0, 1.0}}); }

glm::dvec3 parse_components(XmlSource& source, pugi::xml_node node, ColourUse use) {
    const std::string tag = node.name();
    if (const std::optional<double> grey = parse_grey_spectrum(source, node)) return glm::dvec3(*grey);
    if (is_sampled(node)) return parse_sampled(source, node, use);
    if (!node.attribute("value")) source.fail(node, "<" + tag + "> needs a value");
    const std::string text = node.attribute("value").value();
    const std::vector<std::string_view> parts = tokens(text);
    glm::dvec3 colour(0.0);
    const std::optional<glm::dvec3> hex = parts.size() == 1 && tag != "float" ? parse_hex(parts[0]) : std::nullopt;
    if (hex)
        colour = *hex;
    else if (tag == "float" || tag == "integer")
        colour = glm::dvec3(token_number(source, node, text));
    else if (parts.size() == 1 && parts[0][0] == '#')
        fail_for_form(source, node, std::string(parts[0]), 1);
    else if (parts.size() == 1)
        colour =
            (tag == "spectrum" && use == ColourUse::emission ? uniform_emission() : glm::dvec3(1.0)) * token_number(source, node, parts[0]);
    else if (parts.size() == 3)
        for (int i = 0; i < 3; ++i) colour[i] = token_number(source, node, parts[static_cast<std::size_t>(i)]);
    else
        fail_for_form(source, node, text, parts.size());
    if (tag == "srgb")
        for (int i = 0; i < 3; ++i) colour[i] = srgb_to_linear(colour[i]);
    return colour;
}

}  // namespace

glm::vec3 parse_colour(XmlSource& source, pugi::xml_node node, ColourUse use) {
    const std::string tag = node.name();
    if (tag != "rgb" && tag != "srgb" && tag != "spectrum" && tag != "float" && tag != "integer" && tag != "blackbody") {
        source.fail(node,
                    "<" + tag + "> " + in_quotes(node.attribute("name").value()) + " is not a colour; use <rgb>, <spectrum> or <float>");
    }
    glm::vec3 colour(parse_components(source, node, use));
    const std::string name = std::string(node.attribute("name").value());
    for (int i = 0; i < 3; ++i) {
        if (!std::isfinite(colour[i])) source.fail(node, in_quotes(name) + " is outside the range of single precision");
        if (colour[i] < 0.0F) source.fail(node, in_quotes(name) + " must not be negative");
    }
    if (use != ColourUse::reflectance) return colour;
    if (colour != glm::min(colour, glm::vec3(1.0F)))
        source.approximate(node, in_quotes(name) + " must lie in [0, 1], a surface cannot reflect more light than it receives: cut to 1");
    return glm::min(colour, glm::vec3(1.0F));
}

}  // namespace pencil
