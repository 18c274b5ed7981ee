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
    std::vector<std::string> lines{fmt::format("packets of {} surfels per work-item on {}", device.packet_width(), device.info().name),
                                   light_sentence(context)};
    if (!context.needs.maps.empty())
        lines.push_back(explain_paths(context.device_scene.triangle_count, context.needs.maps,
                                      static_cast<int>(device.info().compute_units), context.prepared));
    if (!context.kernels.features().smooth)
        lines.push_back("left out: shading normals (no vertex normals in the scene): buffer, interpolation and side test");
    if (context.options.bounces == 0) lines.push_back("left out: light samples and pencils (emission only)");
    return lines;
}

}  // namespace pencil
