#include "film/frame.h"

#include <algorithm>
#include <cstdint>

#include "film/emit_surfels.h"
#include "film/light_surfels.h"
#include "visibility/geometry_maps.h"

namespace pencil {

namespace {

/// Surfels that light samples are meant for: so many that some lie in each spot by a lamp that is worth seeing.
constexpr int most_receivers = 1024;

std::vector<LightReceiver> some_receivers(const Film& film) {
    static_assert(SURFEL_X == 0 && SURFEL_NX == 3 && SURFEL_NZ == 5, "positions and normals are the first fields");
    std::vector<LightReceiver> receivers;
    const Surfels& surfels = film.surfels();
    const int count = std::min(surfels.count, most_receivers);
    for (int k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(static_cast<std::int64_t>(k) * surfels.count / count);
        const std::vector<float> f = surfels.data.read_rows(i, static_cast<std::size_t>(surfels.capacity), SURFEL_NZ + 1, 1);
        receivers.push_back({{f[0], f[1], f[2]}, {f[3], f[4], f[5]}});
    }
    return receivers;
}

std::unique_ptr<Film> make_film(RenderContext& context, const Turn& turn, const std::vector<unsigned char>& split = {}) {
    Kernels& kernels = context.kernels;
    const FlatScene& flat = context.flat;
    if (!context.scene.sensor_points.empty())
        return std::make_unique<Film>(kernels, flat.camera, sensor_receivers(kernels, context.scene, flat, turn));
    auto film =
        std::make_unique<Film>(kernels, context.device_scene, FilmCamera{flat.camera, glm::vec3(flat.eye)}, context.scene.sensor.filter,
                               turn, context.options.irradiance ? std::vector<unsigned char>() : split);
    if (context.options.irradiance) film->receive(context.flat.materials);
    return film;
}

}  // namespace

Frame::Frame(RenderContext& context, const std::vector<std::string>& aovs, int light_samples, int light_map, const Turn& turn,
             const std::vector<unsigned char>& split)
    : context_(context), layers_(aovs) {
    Kernels& kernels = context.kernels;
    context.clock.run(
        "film geometry", [&] { film_ = make_film(context, turn, split); });
    context.clock.run(
        "light sample maps", [&] { make_lights(light_samples, light_map, turn); });
    context.clock.run("surface layers", [&] { layers_.add_surfaces(kernels, context.device_scene, context.flat, *film_); });
    context.clock.allow_stops();
}

void Frame::look(const Turn& turn) {
    Kernels& kernels = context_.kernels;
    context_.clock.run("film geometry", [&] { film_ = make_film(context_, turn); });
    outgoing_ = surfel_rgb(kernels.device(), film_->surfels().capacity, "film radiance");
    context_.clock.run("direct light", [&] {
        emit_surfels(kernels, context_.device_scene, film_->surfels(), false, outgoing_);
        if (lights_.maps.count > 0)
            light_surfels(kernels, context_.device_scene, film_->surfels(), lights_, outgoing_, "direct light to film");
    });
}

void Frame::finish_look() {
    context_.clock.run(
        "resolve film", [&] { layers_.show(film_->resolve(context_.kernels, outgoing_)); });
}

void Frame::make_lights(int count, int map, const Turn& turn) {
    if (context_.options.bounces == 0) return;  // emission only
    if (context_.receivers.empty() && has_detailed_emitters(context_.scene, context_.flat, context_.forms))
        context_.receivers = some_receivers(*film_);
    if (context_.light_importance.empty() && !context_.receivers.empty())
        context_.light_importance = light_importance(context_.scene, context_.flat, context_.forms, context_.receivers);
    samples_ = sample_lights(context_.scene, context_.flat, context_.forms, count, turn.seed, turn.index, context_.light_importance);
    if (samples_.empty()) return;
    lights_ = LightSet(context_.kernels.device(), samples_, context_.kernels.map_shape(map));
    if (map > 0) make_geometry_maps(context_.kernels, context_.device_scene, lights_.maps, 0, lights_.maps.count);
}

bool Frame::add_direct(const std::function<void()>& light) {
    RenderStats& stats = context_.stats;
    stats.film_surfels = static_cast<std::uint64_t>(film_->surfels().count);
    if (context_.options.bounces == 0) return false;
    if (dark()) {
        if (stats.warnings.empty()) stats.warnings.push_back("the scene has no light: the image is black");
        return false;
    }
    outgoing_ = surfel_rgb(context_.kernels.device(), film_->surfels().capacity, "film radiance");
    if (lights_.maps.count == 0) return true;
    context_.clock.run("direct light", [&] {
        if (light) return light();
        light_surfels(context_.kernels, context_.device_scene, film_->surfels(), lights_, outgoing_, "direct light to film");
        light_close_ups();
    });
    film_->release_close_ups();
    if (!context_.maps_emit) finish_bounce(1, 0, 0);
    return true;
}

/// Direct light of samples that are looked at closely.
void Frame::light_close_ups() {
    const CloseUps& close = film_->close_ups();
    if (close.each == 0) return;
    Buffer<float> light = surfel_rgb(context_.kernels.device(), close.surfels.capacity, "light of close-ups");
    light_surfels(context_.kernels, context_.device_scene, close.surfels, lights_, light, "direct light to close-ups");
    average_close_ups(context_.kernels, close, film_->first_surfel(), light, outgoing_, film_->surfels().capacity);
}

void Frame::finish_bounce(int order, int pencils, double projection_seconds) {
    context_.clock.run("resolve film", [&] {
        std::vector<float> pixels = film_->resolve(context_.kernels, outgoing_);
        BounceReport report;
        report.order = order;
        report.pencils = pencils;
        report.mean = mean_rgb(pixels);
        report.projection_seconds = projection_seconds;
        context_.stats.bounces.push_back(report);
        layers_.add_bounce(order, std::move(pixels));
    });
    outgoing_.fill_zero();
}

}  // namespace pencil
