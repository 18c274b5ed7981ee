#include "render/photometric_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "image/colour.h"
#include "util/constants.h"

namespace pencil {

namespace {

/// `factor` times the luminance of rgb. What float cannot hold becomes its largest number, with a warning.
Layer photometric_layer(const std::string& name, const std::vector<float>& rgb, double factor, std::vector<std::string>& warnings) {
    Layer layer{name, 1, scaled_luminance(rgb, factor)};
    if (const std::size_t cut = clamp_to_float(rgb, layer.pixels); cut > 0)
        warnings.push_back(fmt::format("{}: {} values are too large for float and became its largest number", name, cut));
    return layer;
}

}  // namespace

RenderOptions irradiance_options(RenderOptions options) {
    options.method = MethodName::surface;
    options.pencils = pencils_of_method;
    options.irradiance = true;
    options.aovs = {};
    return options;
}

IrradianceImage add_photometric_layers(const std::vector<std::string>& aovs, double lumens_per_watt,
                                       const std::function<IrradianceImage()>& solve, std::vector<Layer>& layers) {
    IrradianceImage made;
    std::vector<std::string> warnings;
    if (layers.empty()) return made;
    if (has_group(aovs, luminance_layer))
        layers.push_back(photometric_layer(luminance_layer, layers.front().pixels, lumens_per_watt, warnings));
    if (has_group(aovs, illuminance_layer)) made = solve();
    for (const std::string& warning : made.warnings) warnings.push_back(fmt::format("{}: {}", illuminance_layer, warning));
    if (!made.layers.empty())
        layers.push_back(photometric_layer(illuminance_layer, made.layers.front().pixels, pi * lumens_per_watt, warnings));
    made.warnings = warnings;
    return made;
}

std::vector<std::string> mixed_lights(const Scene& scene, double asked) {
    const auto emitting = std::count_if(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) { return shape.emits; });
    const auto all =
        static_cast<std::ptrdiff_t>(scene.point_lights.size() + scene.directional_lights.size()) + emitting + (scene.environment ? 1 : 0);
    const int photometric = scene.photometric_lights;
    if (asked != efficacy_of_scene || photometric == 0 || photometric == all) return {};
    return {fmt::format(
        "{} of {} lights are given in lumens or candela, {} of which are a watt here; the others are not, and count {} lumens a watt, too, "
        "not the {} of white light: --lumens-per-watt chooses one factor for all",
        photometric, all, standard_efficacy(true), standard_efficacy(true), standard_efficacy(false))};
}

}  // namespace pencil
