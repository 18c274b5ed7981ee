#include "render/render_session.h"

#include <fmt/format.h>

#include <algorithm>

#include "film/film.h"
#include "film/render_context.h"
#include "options/render_option_table.h"
#include "options/scale_light.h"
#include "render/explain.h"
#include "render/methods.h"
#include "util/archive.h"
#include "util/error.h"

namespace pencil {

namespace {

void check_memory(const RenderOptions& options, const Device& device) {
    const double bytes = film_bytes(static_cast<double>(options.width) * options.height, options.film_samples);
    const auto available = static_cast<double>(device.info().global_memory);
    const auto mebibytes = [](double size) { return std::to_string(static_cast<long long>(size / (1 << 20))) + " MiB"; };
    if (bytes > available)
        throw MemoryError(fmt::format("a film of {}x{} pixels needs about {} of device memory, {} exist; use a smaller --resolution",
                                      options.width, options.height, mebibytes(bytes), mebibytes(available)));
}

bool has_lobes(const Scene& scene) {
    return std::any_of(
        scene.materials.begin(), scene.materials.end(),
        [](const SceneMaterial& m) { return m.model != MATERIAL_DIFFUSE && m.model != MATERIAL_BLEND; });
}

/// A field has the orders that it has: no --bounces beside it.
int bounces_of(const PencilField& field, int asked) {
    const int shown = field.orders < 0 ? endless_bounces : field.orders + 1;
    if (asked != bounces_of_scene && asked != shown)
        throw UsageError("--bounces: is decided by the --field, which holds " +
                         (field.orders < 0 ? "all orders of reflection" : fmt::format("light of up to {} reflections", field.orders)));
    return shown;
}

RenderOptions checked(const RenderOptions& options, const Scene& scene, const Device& device) {
    RenderOptions complete = resolve(options, scene);
    if ((complete.irradiance || !scene.sensor_points.empty()) && complete.method != MethodName::surface)
        throw UsageError("irradiance is measured by the surface method alone; leave out --method");
    for (const auto& [flag, own] : {std::pair("--radiance-map", complete.radiance_map), std::pair("--density-map", complete.density_map)})
        if (own > complete.map) throw UsageError(fmt::format("{}: {} is more than --map, which is {}", flag, own, complete.map));
    check_options(complete);  // the kernels rely on these limits, whoever calls
    check_memory(complete, device);
    return complete;
}

}  // namespace

RenderOptions resolve(const RenderOptions& options, const Scene& scene) {
    RenderOptions complete = options;
    if (complete.target_error == target_of_scene) complete.target_error = standard_target(has_lobes(scene));
    if (complete.pencils == pencils_of_method) complete.pencils = standard_pencils(complete.method);
    if (complete.least_pencils == pencils_of_method) complete.least_pencils = standard_least_pencils(complete.method);
    if (complete.bounces == bounces_of_scene) complete.bounces = scene_bounces(scene);
    if (complete.field) complete.bounces = bounces_of(*complete.field, options.bounces);
    if (complete.field && complete.method != MethodName::surface) {
        complete.map = complete.field->map;
        complete.radiance_map = complete.density_map = 0;
        complete.pencils = shows_part(complete) ? std::min(complete.field_pencils, complete.field->count()) : complete.field->count();
    }
    complete.lumens_per_watt = efficacy_of(complete.lumens_per_watt, scene.photometric_lights > 0);
    if (!scene.sensor_points.empty()) {
        complete.width = static_cast<int>(scene.sensor_points.size());
        complete.height = complete.film_samples = 1;
    }
    if (complete.width <= 0) {
        const PerspectiveSensor& sensor = scene.sensor;
        complete.width = sensor.crop_width > 0 ? sensor.crop_width : sensor.width;
        complete.height = sensor.crop_width > 0 ? sensor.crop_height : sensor.height;
    }
    return complete;
}

RenderSession::RenderSession(const Scene& scene, const RenderOptions& options, const std::shared_ptr<Device>& device,
                             const Progress& progress, const std::vector<std::shared_ptr<Device>>& helpers)
    : context_(std::make_unique<RenderContext>(scene, checked(options, scene, *device), find_method(options.method).needs, device, progress,
                                               helpers)),
      method_(find_method(options.method).make(*context_)) {}

RenderSession::~RenderSession() = default;

bool RenderSession::advance() {
    if (ended_) return false;
    try {
        complete_ = !method_->advance();
        has_step_ = true;
        ended_ = complete_ || context_->clock.stopped();
    } catch (const Stopped&) {
        ended_ = true;
    } catch (...) {
        ended_ = true;  // the step is half done
        throw;
    }
    return !ended_;
}

void RenderSession::look(const PerspectiveSensor& sensor) {
    RenderContext& context = *context_;
    if (sensor.orthographic || sensor.aperture_radius > 0) throw UsageError("a view of a field is that of a pinhole");
    if (!method_->can_look()) throw UsageError("the light of a render is made for one camera; only a --field has light for others");
    flatten_camera(sensor, context.options.width, context.options.height, context.flat);
    context.device_scene.look(context.flat);
    context.stats.bounces.clear();
    try {
        method_->look();
    } catch (const Stopped&) {
        ended_ = true;
    }
}

bool RenderSession::resumable() const { return method_->resumable(); }

std::vector<char> RenderSession::save() {
    if (!method_->resumable()) throw UsageError("--method " + to_string(context_->options.method) + " cannot go on from a checkpoint");
    Archive archive;
    RenderOptions until = context_->options;
    archive(complete_, until.target_error, until.seconds);
    method_->transfer(archive);
    return archive.take();
}

void RenderSession::resume(std::vector<char> state) {
    if (!method_->resumable()) throw UsageError("--method " + to_string(context_->options.method) + " cannot go on from a checkpoint");
    Archive archive(std::move(state));
    RenderOptions until;
    archive(complete_, until.target_error, until.seconds);
    try {
        method_->transfer(archive);
        has_step_ = true;
    } catch (const Stopped&) {
        has_step_ = ended_ = true;  // all but the world set has been read
        return;
    } catch (...) {
        ended_ = true;
        throw;
    }
    ended_ = complete_ && until.target_error == context_->options.target_error && until.seconds == context_->options.seconds;
}

std::vector<Layer> RenderSession::snapshot() const {
    std::vector<Layer> layers = method_->snapshot();
    scale_light(context_->flat.normalisation.light, layers);
    return layers;
}
double RenderSession::estimated_error() const { return method_->estimated_error(); }
bool RenderSession::interrupted() const { return context_->clock.stopped(); }
const RenderOptions& RenderSession::options() const { return context_->options; }

RenderStats RenderSession::stats() const {
    RenderStats stats = context_->stats;
    for (BounceReport& bounce : stats.bounces) bounce.mean *= context_->flat.normalisation.light;
    if (!stats.stopped.empty()) stats.warnings.push_back(stats.stopped);
    const HelperReport& helpers = context_->helpers;
    stats.warnings.insert(stats.warnings.end(), helpers.notes.begin(), helpers.notes.end());
    stats.device_pencils = helpers.pencils;
    stats.explain = explain(*context_);
    const std::vector<std::string> own = method_->explain();
    stats.explain.insert(stats.explain.end(), own.begin(), own.end());
    stats.stages = context_->clock.stages();
    stats.estimated_error = method_->estimated_error();
    stats.certified = method_->certified_error();
    stats.device_peak_bytes = context_->kernels.device()->peak_allocated();
    stats.triangles = context_->flat.triangles.size();
    return stats;
}

void RenderSession::let_go() {
    ended_ = true;
    method_->let_go();
    context_->copies.clear();
}

RenderResult RenderSession::finish() {
    ended_ = true;
    RenderResult result;
    result.stats = stats();
    result.field = method_->field();
    result.layers = method_->take();
    const std::vector<std::string> warnings = scale_light(context_->flat.normalisation.light, result.layers);
    result.stats.warnings.insert(result.stats.warnings.end(), warnings.begin(), warnings.end());
    result.width = context_->options.width;
    result.height = context_->options.height;
    result.interrupted = interrupted();
    return result;
}

}  // namespace pencil
