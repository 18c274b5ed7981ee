// Forms: <spectrum value="400:0.1, 700:0.9"/>, <spectrum filename="gold.spd"/>, <spectrum type="irregular"> and its relatives with nested
// parameters (Mitsuba 3), <blackbody temperature="5000K" scale="1"/> (0.x).
#include "scene/mitsuba/parse_spectrum.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/scene_file.h"
#include "scene/text.h"

namespace pencil {
namespace {

constexpr std::uintmax_t max_spectrum_bytes = 1 << 20;
constexpr double first_wavelength = 360.0, last_wavelength = 830.0;  // [nm], of curves without an end of their own

SampledSpectrum of_pairs(XmlSource& source, pugi::xml_node node) {
    SampledSpectrum spectrum;
    for (const std::string_view token : tokens(node.attribute("value").value())) {
        const std::size_t colon = token.find(':');
        if (colon == std::string_view::npos) source.fail(node, "a spectrum mixes wavelength:value pairs with " + in_quotes(token));
        spectrum.wavelengths.push_back(token_number(source, node, token.substr(0, colon)));
        spectrum.values.push_back(token_number(source, node, token.substr(colon + 1)));
    }
    return spectrum;
}

/// Lines of a wavelength and a value; # begins a comment.
SampledSpectrum of_file(XmlSource& source, pugi::xml_node node) {
    const std::string text =
        read_regular_file(source.find_file(node.attribute("filename").value(), node), max_spectrum_bytes, source.where(node));
    SampledSpectrum spectrum;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, std::min(rest.find('#'), end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const std::vector<std::string_view> parts = tokens(line);
        if (parts.empty()) continue;
        if (parts.size() < 2) source.fail(node, "a line of the spectrum file is no wavelength and value: " + in_quotes(line));
        spectrum.wavelengths.push_back(token_number(source, node, parts[0]));
        spectrum.values.push_back(token_number(source, node, parts[1]));
    }
    return spectrum;
}

/// Planck's law [W m^-2 sr^-1 nm^-1].
double planck(double wavelength, double kelvin) {
    constexpr double h = 6.62607015e-34, c = 299792458.0, k = 1.380649e-23;
    const double metres = wavelength * 1e-9;
    return 2.0 * h * c * c / (std::pow(metres, 5.0) * std::expm1(h * c / (metres * k * kelvin))) * 1e-9;
}

SampledSpectrum black_body(XmlSource& source, pugi::xml_node node, double kelvin, double scale) {
    if (!(kelvin > 0.0)) source.fail(node, "a temperature must be positive");
    SampledSpectrum spectrum;
    for (double wavelength = first_wavelength; wavelength <= last_wavelength; wavelength += 5.0) {
        spectrum.wavelengths.push_back(wavelength);
        spectrum.values.push_back(planck(wavelength, kelvin) * scale);
    }
    return spectrum;
}

/// "5000K" or "5000"
double kelvin_of(XmlSource& source, pugi::xml_node node) {
    std::string_view text = trimmed(node.attribute("temperature").value());
    if (!text.empty() && (text.back() == 'K' || text.back() == 'k')) text.remove_suffix(1);
    return token_number(source, node, text);
}

/// A parameter nested in a spectrum plugin, or its attribute.
std::string_view nested(pugi::xml_node node, const char* name) {
    for (const pugi::xml_node child : node.children())
        if (std::strcmp(child.attribute("name").value(), name) == 0) return child.attribute("value").value();
    return node.attribute(name).value();
}

double nested_number(XmlSource& source, pugi::xml_node node, const char* name, double absent) {
    const std::string_view text = nested(node, name);
    return text.empty() ? absent : token_number(source, node, text);
}

SampledSpectrum of_plugin(XmlSource& source, pugi::xml_node node) {
    const std::string type = node.attribute("type").value();
    if (type == "blackbody")
        return black_body(source, node, nested_number(source, node, "temperature", 5000), nested_number(source, node, "scale", 1));
    SampledSpectrum spectrum;
    for (const std::string_view token : tokens(nested(node, "values"))) spectrum.values.push_back(token_number(source, node, token));
    for (const std::string_view token : tokens(nested(node, "wavelengths")))
        spectrum.wavelengths.push_back(token_number(source, node, token));
    if (type == "regular") {
        const double first = nested_number(source, node, "wavelength_min", first_wavelength);
        const double last = nested_number(source, node, "wavelength_max", last_wavelength);
        const double steps = std::max(1.0, static_cast<double>(spectrum.values.size()) - 1);
        for (std::size_t i = 0; i < spectrum.values.size(); ++i)
            spectrum.wavelengths.push_back(first + (last - first) * static_cast<double>(i) / steps);
    }
    if (spectrum.values.size() != spectrum.wavelengths.size()) source.fail(node, "a spectrum needs as many values as wavelengths");
    return spectrum;
}

}  // namespace

double token_number(const XmlSource& source, pugi::xml_node node, std::string_view token) {
    const std::optional<double> value = parse_number(token);
    if (!value)
        source.fail(node, std::string("<") + node.name() + "> " + in_quotes(node.attribute("name").value()) + ": " + number_defect(token));
    return *value;
}

bool is_sampled(pugi::xml_node node) {
    if (std::strcmp(node.name(), "blackbody") == 0) return true;
    if (std::strcmp(node.name(), "spectrum") != 0) return false;
    return node.attribute("filename") || node.attribute("type") || std::strchr(node.attribute("value").value(), ':') != nullptr;
}

std::optional<double> parse_grey_spectrum(XmlSource& source, pugi::xml_node node) {
    const std::string type = node.attribute("type").value();
    if (std::strcmp(node.name(), "spectrum") != 0 || type.empty() || type == "regular" || type == "irregular" || type == "blackbody")
        return std::nullopt;
    if (type != "d65" && type != "uniform")
        source.approximate(node, "spectrum type " + in_quotes(type) + " is not supported: read as a uniform one");
    return nested_number(source, node, type == "d65" ? "scale" : "value", 1);
}

SampledSpectrum parse_spectrum(XmlSource& source, pugi::xml_node node) {
    if (std::strcmp(node.name(), "blackbody") == 0)
        return black_body(source, node, kelvin_of(source, node),
                          node.attribute("scale") ? token_number(source, node, node.attribute("scale").value()) : 1);
    if (node.attribute("filename")) return of_file(source, node);
    return node.attribute("type") ? of_plugin(source, node) : of_pairs(source, node);
}

}  // namespace pencil
