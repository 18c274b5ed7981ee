#include "render/explain.h"

#include <fmt/format.h>

#include "pencils/light_samples.h"

namespace pencil {

namespace {

std::string light_sentence(const RenderContext& context) {
    std::size_t samples = 0, maps = 0;
    for (std::size_t i = 0; i < context.scene.shapes.size(); ++i)
        if (context.scene.shapes[i].emits) ++(context.forms[i] == LightForm::maps ? maps : samples);
    std::string why = context.options.initial == Initial::automatic
                          ? fmt::format(" (auto: an emitter of more than {} % of the scene's surface is carried by the maps)",
                                        static_cast<int>(100 * large_emitter))
                          : " (as asked)";
    return fmt::format(
        "direct light: {} point lights and {} emitting shapes by light samples, {} emitting shapes carried by the pencil maps{}",
        context.scene.point_lights.size(), samples, maps, why);
}

}  // namespace

std::vector<std::string> explain(const RenderContext& context) {
    const Device& device = *context.kernels.device();
    std::vector<std::string> lines{fmt::format("packets of {} surfels per work-item on {}{}", device.packet_width(), device.info().name,
                                               device.profile().tuned ? ", as `pencil tune` has measured" : ""),
                                   light_sentence(context)};
    if (!context.needs.maps.empty())
        lines.push_back(explain_paths(context.device_scene.triangle_count, context.needs.maps, MapSpeed(device), context.prepared,
                                      context.needs.map_kind));
    const Features& features = context.kernels.features();
    if (context.prepared.bvh)
        lines.push_back(fmt::format("hierarchy of {} triangles: {}", context.device_scene.triangle_count,
                                    features.wide_bvh ? "eight children per node, rays that part go alone (many triangles)"
                                                      : "two children per node, rays go in packets"));
    const auto left_out = [&](bool needed, const char* what) {
        if (!needed) lines.push_back(std::string("left out: ") + what);
    };
    left_out(features.lobes, "lobes (no mirror, glass or gloss in the scene): chains of rays, 48 bytes a surfel, a program of kernels");
    left_out(features.textures, "textures: texture coordinates, texels, look-ups");
    left_out(features.blends, "blends and masks: choice among materials");
    left_out(features.relief, "bump and normal maps");
    left_out(features.clear, "clear things in shadows: rays to lights stop at the first surface");
    left_out(features.sky, "environment: its map, look-ups where rays meet nothing, the background of the film");
    left_out(features.wide_camera, "lenses and parallel rays: the film is seen from one point");
    if (!features.smooth)
        lines.push_back("left out: shading normals (no vertex normals in the scene): buffer, interpolation and side test");
    if (context.options.bounces == 0) lines.push_back("left out: light samples and pencils (emission only)");
    return lines;
}

}  // namespace pencil
