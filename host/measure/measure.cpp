#include "measure/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "film/layer_mean.h"
#include "image/relative_error.h"
#include "measure/sensor_film.h"
#include "reference/path_tracer.h"
#include "render/render_session.h"

namespace pencil {

namespace {

using Values = std::vector<double>;

constexpr double pi = 3.14159265358979323846;
/// Of the time, for direct light alone: it has no bounces to find.
constexpr double direct_share = 0.15;
/// Relative errors that neither spread nor check paths see: of sums in single precision, and of photometric files, whose tables are half floats.
constexpr double rounding = 1e-5, table_rounding = 3e-4;

/// Of each sensor [lx], 0 where the layer is missing.
Values layer_values(const std::vector<Layer>& layers, const std::string& name, std::size_t sensors, double lumens_per_watt) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const Layer& layer) { return layer.name == name; });
    return found == layers.end() ? Values(sensors, 0.0) : pixel_luminances(found->pixels, pi * lumens_per_watt);
}

/// Standard errors of what the surface method says: the spread of its passes, and what they share, about which check paths know more. Of this
/// the upper end of their interval counts. One pass has no spread, and alone says nothing.
Values joined_errors(const Values& values, const Values& spread, const CertifiedError& certified, int passes) {
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double known = 0;  // relative square of the spread
    for (std::size_t i = 0; i < values.size(); ++i)
        if (mean > 0) known += spread[i] * spread[i] / relative_to(values[i], mean) / count;
    if (passes < 2 && certified.points < 2) return Values(values.size(), std::numeric_limits<double>::infinity());
    const double most = std::max(certified.relmse, 0.0) + interval_errors * certified.standard_error,
                 shared = certified.points > 1 ? std::max(most - known, 0.0) : 0.0;
    Values errors;
    for (std::size_t i = 0; i < values.size(); ++i)
        errors.push_back(std::hypot(student(passes) * spread[i], std::sqrt(shared * relative_to(values[i], mean))));
    return errors;
}

std::vector<Illuminance> with_intervals(const Scene& scene, const Values& values, const Values& errors, const Values& direct) {
    const double unseen = scene.profiles.empty() ? rounding : table_rounding;
    std::vector<Illuminance> sensors;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double width = interval_errors * std::hypot(errors[i], unseen * values[i]);
        sensors.push_back({values[i], std::max(values[i] - width, 0.0), values[i] + width, std::min(direct[i], values[i])});
    }
    return sensors;
}

}  // namespace

Measurements measure(const Scene& scene, const std::vector<Sensor>& sensors, const RenderOptions& options,
                     const std::shared_ptr<Device>& device, const Progress& progress) {
    const Scene measured = with_sensors(scene, sensors);
    RenderOptions all = options;
    all.method = MethodName::surface;
    all.aovs = {};
    all = resolve(all, measured);
    RenderOptions straight = all;
    straight.bounces = 1;
    straight.seconds = direct_share * all.seconds;
    all.seconds -= straight.seconds;
    const RenderResult direct = render(measured, straight, device, progress);
    const RenderResult result = direct.interrupted ? RenderResult() : render(measured, all, device, progress);
    Measurements found;
    found.interrupted = direct.interrupted || result.interrupted;
    found.passes = result.stats.passes;
    found.certified = result.stats.certified;
    found.warnings = result.stats.warnings;
    if (result.layers.empty()) return found;
    const auto values_of = [&](const RenderResult& of, const char* layer) {
        return layer_values(of.layers, layer, sensors.size(), all.lumens_per_watt);
    };
    const Values values = values_of(result, "");
    const Values errors = joined_errors(values, values_of(result, error_layer), found.certified, found.passes);
    found.sensors = with_intervals(scene, values, errors, values_of(direct, ""));
    return found;
}

Measurements measure_by_paths(const Scene& scene, const std::vector<Sensor>& sensors, const ReferenceOptions& options,
                              double lumens_per_watt, const Progress& progress) {
    ReferenceOptions asked = options;
    asked.bounces = asked.variance = true;
    asked.surfaces = false;
    ReferenceResult result = trace_paths(with_sensors(scene, sensors), asked, progress);
    Measurements found;
    found.interrupted = result.interrupted;
    found.warnings = result.warnings;
    if (result.spp == 0) return found;
    for (Layer& layer : result.layers)
        if (layer.name == variance_layer)
            for (float& variance : layer.pixels) variance = std::sqrt(variance);
    const auto values_of = [&](const char* layer) { return layer_values(result.layers, layer, sensors.size(), lumens_per_watt); };
    found.sensors = with_intervals(scene, values_of(""), values_of(variance_layer), values_of(direct_layer));
    return found;
}

}  // namespace pencil
