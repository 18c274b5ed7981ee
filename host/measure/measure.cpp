#include "measure/measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "film/layer_mean.h"
#include "image/colour.h"
#include "image/relative_error.h"
#include "measure/sensor_film.h"
#include "reference/path_tracer.h"
#include "render/render_session.h"
#include "util/constants.h"

namespace pencil {

namespace {

using Values = std::vector<double>;

/// Direct light alone goes on as long as all light does [s].
constexpr double endless = 1e6;
constexpr double unknown = std::numeric_limits<double>::infinity();
/// Relative errors that neither spread nor check paths see: of sums in single precision, and of photometric files, whose tables are half floats.
constexpr double rounding = 1e-5, table_rounding = 3e-4;

/// Of each sensor [lx], 0 where the layer is missing.
Values layer_values(const std::vector<Layer>& layers, const std::string& name, std::size_t sensors, double lumens_per_watt) {
    const auto found = std::find_if(layers.begin(), layers.end(), [&](const Layer& layer) { return layer.name == name; });
    if (found == layers.end()) return Values(sensors, 0.0);
    const std::vector<float> values = scaled_luminance(found->pixels, pi * lumens_per_watt);
    return Values(values.begin(), values.end());
}

/// Standard errors of what the surface method says: the spread of its passes, and what they share, about which check paths know more. Of this
/// the upper end of their interval counts. One pass has no spread, and alone says nothing.
Values joined_errors(const Values& values, const Values& spread, const CertifiedError& certified, int passes) {
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double known = 0;  // relative square of the spread
    for (std::size_t i = 0; i < values.size(); ++i)
        if (mean > 0) known += spread[i] * spread[i] / relative_to(values[i], mean) / count;
    if (passes < 2 && certified.points < 2) return Values(values.size(), unknown);
    const double most = std::max(certified.relmse, 0.0) + interval_errors * certified.standard_error,
                 shared = certified.points > 1 ? std::max(most - known, 0.0) : 0.0;
    Values errors;
    for (std::size_t i = 0; i < values.size(); ++i)
        errors.push_back(
            std::hypot(student(std::min(passes, LayerMean::sequences)) * spread[i], std::sqrt(shared * relative_to(values[i], mean))));
    return errors;
}

/// Of shapes, one pass and its check know a few places alone.
void forget_shapes(const std::vector<Sensor>& sensors, Values& errors) {
    for (std::size_t i = 0; i < sensors.size(); ++i)
        if (sensors[i].place.shape >= 0) errors[i] = unknown;
}

std::vector<Illuminance> with_intervals(const Scene& scene, const Values& values, const Values& errors, const Values& direct) {
    const double unseen = scene.profiles.empty() ? rounding : table_rounding;
    std::vector<Illuminance> sensors;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double width = interval_errors * std::hypot(errors[i], unseen * values[i]);
        sensors.push_back({values[i], std::max(values[i] - width, 0.0), values[i] + width, direct[i]});
    }
    return sensors;
}

/// Results of all light and of direct light alone.
struct Solved {
    RenderResult all, direct;
};

/// Both take their passes in turn, direct light first: what is interrupted has it at least.
Solved solve(const Scene& scene, const RenderOptions& options, const std::shared_ptr<Device>& device, const Progress& progress) {
    RenderOptions straight = options;
    straight.bounces = 1;
    straight.seconds = endless;
    double done = 0;
    const Progress of_all = [&](const std::string&stage, double fraction) { return !progress || progress(stage, done = fraction); },
                   of_direct = [&](const std::string&stage, double) { return !progress || progress(stage, done); };
    RenderSession all(scene, options, device, of_all), direct(scene, straight, device, of_direct);
    do {
        direct.advance();
    } while (!direct.interrupted() && all.advance());
    return {all.finish(), direct.finish()};
}

}  // namespace

Measurements measure(const Scene& scene, const std::vector<Sensor>& sensors, const RenderOptions& options,
                     const std::shared_ptr<Device>& device, const Progress& progress) {
    const Scene measured = with_sensors(scene, sensors);
    RenderOptions all = options;
    all.method = MethodName::surface;
    all.aovs = {};
    all = resolve(all, measured);
    const Solved solved = solve(measured, all, device, progress);
    const RenderStats& stats = solved.all.stats;
    Measurements found;
    found.interrupted = solved.all.interrupted || solved.direct.interrupted;
    found.passes = stats.passes;
    found.certified = stats.certified;
    found.warnings = stats.warnings;
    found.converged = stats.converged;
    if (solved.direct.layers.empty()) return found;
    const auto values_of = [&](const RenderResult& of, const char* layer) {
        return layer_values(of.layers, layer, sensors.size(), all.lumens_per_watt);
    };
    const Values direct = values_of(solved.direct, ""), values = solved.all.layers.empty() ? direct : values_of(solved.all, "");
    Values errors = joined_errors(values, values_of(solved.all, error_layer), found.certified, found.passes);
    if (found.passes < 2) forget_shapes(sensors, errors);
    if (!found.converged) errors.assign(errors.size(), unknown);
    found.sensors = with_intervals(scene, values, errors, direct);
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
    Values errors = values_of(variance_layer);
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (result.sets[i] < 2) errors[i] = unknown;
    found.sensors = with_intervals(scene, values_of(""), errors, values_of(direct_layer));
    return found;
}

}  // namespace pencil
