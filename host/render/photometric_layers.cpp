#include "render/photometric_layers.h"

#include "image/colour.h"
#include "util/stopwatch.h"

namespace pencil {

namespace {

constexpr double pi = 3.14159265358979323846;

/// The surface method alone knows irradiance; its film is the same.
RenderOptions irradiance_options(RenderOptions options) {
    options.method = MethodName::surface;
    options.pencils = pencils_of_method;
    options.irradiance = true;
    options.aovs = {};
    return options;
}

}  // namespace

void add_photometric_layers(const RenderOptions& options, double lumens_per_watt,
                            const std::function<RenderResult(const RenderOptions&)>& solve, RenderResult& result) {
    if (result.layers.empty()) return;
    if (has_group(options.aovs, luminance_layer))
        result.layers.push_back({luminance_layer, 1, scaled_luminance(result.layers.front().pixels, lumens_per_watt)});
    if (!has_group(options.aovs, illuminance_layer) || result.interrupted) return;
    const Stopwatch watch;
    const RenderResult irradiance = solve(irradiance_options(options));
    result.interrupted = irradiance.interrupted;
    result.stats.stages.push_back({illuminance_layer, watch.seconds(), 0, 0, {}});
    if (irradiance.layers.empty()) return;
    result.layers.push_back({illuminance_layer, 1, scaled_luminance(irradiance.layers.front().pixels, pi * lumens_per_watt)});
}

}  // namespace pencil
