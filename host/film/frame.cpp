#include "film/frame.h"

#include <algorithm>

#include "line/placement/candidate_source.h"
#include "visibility/geometry_maps.h"
#include "film/light_surfels.h"
#include "line/planned_maps.h"

namespace pencil {

namespace {

/// Tiles of light samples are finer than pencil maps, because shadow edges are seen directly, but not finer than this.
constexpr int light_map_factor = 4;
constexpr int largest_light_map = 256;

Prepared preparation(const RenderContext& context) {
    if (context.kernels.features().bvh) return {false, true};
    const int units = static_cast<int>(context.kernels.device()->info().compute_units);
    return plan_preparation(static_cast<int>(context.flat.triangles.size()), context.batches, units);
}

DeviceScene prepare_scene(RenderContext& context) {
    Bvh bvh;
    Clusters clusters;
    const bool rays = context.options.method == Method::line && follows_rays(context.options.placement);
    context.prepared.bvh = context.prepared.bvh || rays;
    if (context.prepared.bvh) context.clock.run("hierarchy", [&] { bvh = build_bvh(context.flat.triangles); });
    if (context.prepared.clusters) context.clock.run("clusters", [&] { clusters = cluster_triangles(context.flat.triangles); });
    return DeviceScene(context.kernels.device(), context.flat, bvh, clusters);
}

}  // namespace

int light_map_size(int map) { return std::max(map, std::min(light_map_factor * map, largest_light_map)); }

RenderContext::RenderContext(const Scene& scene_to_render, const RenderOptions& render_options, const std::shared_ptr<Device>& device,
                             const Progress& progress)
    : scene(scene_to_render),
      options(render_options),
      forms(choose_light_forms(scene, options.initial == Initial::direct, options.initial == Initial::emission)),
      flat(flatten(scene, forms, options.width, options.height)),
      kernels(device, detect_features(flat, options)),
      clock(device, progress),
      batches(planned_maps(scene, forms, options)),
      prepared(preparation(*this)),
      device_scene(prepare_scene(*this)) {
    for (std::size_t i = 0; i < forms.size(); ++i) maps_emit = maps_emit || (scene.shapes[i].emits && forms[i] == LightForm::maps);
}

Frame::Frame(RenderContext& context, const std::vector<std::string>& aovs, int light_samples, int light_map, const Turn& turn)
    : context_(context), layers_(aovs) {
    Kernels& kernels = context.kernels;
    context.clock.run("film geometry", [&] {
        film_ = std::make_unique<Film>(kernels, context.device_scene, context.flat.camera, context.scene.sensor.filter, turn);
    });
    context.clock.run("light sample maps", [&] { make_lights(light_samples, light_map, turn); });
    context.clock.run("surface layers", [&] { layers_.add_surfaces(kernels, context.device_scene, context.flat, *film_); });
}

void Frame::make_lights(int count, int map, const Turn& turn) {
    if (context_.options.bounces == 0) return;  // emission only
    samples_ = sample_lights(context_.scene, context_.flat, context_.forms, count, turn.seed, turn.index);
    if (samples_.empty()) return;
    lights_ = LightSet(context_.kernels.device(), samples_, map);
    if (map > 0) make_geometry_maps(context_.kernels, context_.device_scene, lights_.maps, 0, lights_.maps.count);
}

void Frame::add_direct() {
    outgoing_ = surfel_rgb(context_.kernels.device(), film_->surfels().capacity, "film radiance");
    if (lights_.maps.count == 0) return;
    context_.clock.run("direct light", [&] {
        light_surfels(context_.kernels, context_.device_scene, film_->surfels(), lights_, outgoing_, "direct light to film");
    });
    if (!context_.maps_emit) finish_bounce(1, 0, 0);
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
