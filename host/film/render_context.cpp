#include "film/render_context.h"

#include "device/radiance_atlas.h"
#include "film/approximations.h"
#include "pencils/light_samples.h"

namespace pencil {

namespace {

Features complete_features(const FlatScene& flat, const RenderOptions& options, const MethodNeeds& needs, const Device& device) {
    Features features = scene_features(flat, options.film_samples, needs.lobes);
    features.bvh = needs.rays_for_visibility;
    features.weights = needs.weights;
    features.cell_grid = needs.cell_grid;
    features.map_kind = needs.map_kind;
    features.wide_bvh = wants_wide_bvh(device.packet_width(), flat.triangles.size());
    features.atlas_image = needs.atlas && atlas_is_image(options.atlas, device, MapShape(needs.map_kind, options.map), options.pencils);
    return features;
}

/// Those of every film, then the method's. Not the very first, which a render builds before another process could.
std::vector<SureKernel> sure_kernels(const RenderContext& context) {
    const auto pixels = static_cast<std::size_t>(context.flat.camera.width) * static_cast<std::size_t>(context.flat.camera.height);
    std::vector<SureKernel> sure{{"classify_film", pixels}, {"emit_surfels", pixels}, {"whole_pixels", pixels},
                                 {"resolve_film", pixels},  {"film_surfels", pixels}, {"light_surfels"}};
    sure.insert(sure.end(), context.needs.kernels.begin(), context.needs.kernels.end());
    return sure;
}

Prepared preparation(const FlatScene& flat, const MethodNeeds& needs, const Device& device) {
    Prepared prepared;
    if (!needs.maps.empty())
        prepared = plan_preparation(static_cast<int>(flat.triangles.size()), needs.maps, MapSpeed(device), needs.map_kind);
    prepared.bvh = prepared.bvh || needs.hierarchy;
    return prepared;
}

DeviceScene prepare_scene(RenderContext& context, const std::vector<std::shared_ptr<Device>>& helping) {
    context.kernels.build_ahead(sure_kernels(context));
    Hierarchy bvh;
    Clusters clusters;
    if (context.prepared.bvh)
        context.clock.run("hierarchy", [&] { bvh = build_hierarchy(context.flat, context.kernels.features().wide_bvh); });
    if (context.prepared.clusters) context.clock.run("clusters", [&] { clusters = cluster_triangles(context.flat.triangles); });
    for (const std::shared_ptr<Device>& helper : helping) try {
            context.copies.push_back(std::make_unique<DeviceCopy>(
                DeviceCopy{Kernels(helper, context.kernels.features()), DeviceScene(helper, context.flat, bvh, clusters), {}}));
        } catch (const std::exception& error) {
            context.helpers.notes.push_back(helper->info().name + " does not help: " + error.what());
        }
    return DeviceScene(context.kernels.device(), context.flat, bvh, clusters);
}

}  // namespace

RenderContext::RenderContext(const Scene& scene_to_render, const RenderOptions& render_options, NeedsOf needs_of,
                             const std::shared_ptr<Device>& device, const Progress& progress,
                             const std::vector<std::shared_ptr<Device>>& helping)
    : scene(scene_to_render),
      options(render_options),
      clock(device, progress),
      forms(choose_light_forms(scene, options.initial == Initial::direct, options.initial == Initial::emission)),
      flat(flatten(scene, forms, options.width, options.height, light_unit(scene))),
      needs(needs_of(scene, forms, options)),
      kernels(device, complete_features(flat, options, needs, *device)),
      prepared(preparation(flat, needs, *device)),
      device_scene(prepare_scene(*this, helping)) {
    maps_emit = flat.sky.width > 0 || kernels.features().lobes || maps_carry_emitters(scene, forms);
    for (std::string& sentence : approximations(scene, needs)) stats.warnings.push_back("approximated: " + std::move(sentence));
    kernels.before_launch([this] { clock.poll(); });
}

}  // namespace pencil
