#include "render/explain.h"

#include "pencils/light_samples.h"

namespace pencil {

namespace {

std::string light_sentence(const RenderContext& context) {
    std::size_t samples = 0, maps = 0;
    for (std::size_t i = 0; i < context.scene.shapes.size(); ++i)
        if (context.scene.shapes[i].emits) ++(context.forms[i] == LightForm::maps ? maps : samples);
    std::string why = context.options.initial == Initial::automatic
                          ? " (auto: an emitter of more than " + std::to_string(static_cast<int>(100 * large_emitter)) +
                                " % of the scene's surface is carried by the maps)"
                          : " (as asked)";
    return "direct light: " + std::to_string(context.scene.point_lights.size()) + " point lights and " + std::to_string(samples) +
           " emitting shapes by light samples, " + std::to_string(maps) + " emitting shapes carried by the pencil maps" + why;
}

}  // namespace

std::vector<std::string> explain(const RenderContext& context) {
    const Device& device = *context.kernels.device();
    std::vector<std::string> lines{
        "packets of " + std::to_string(device.packet_width()) + " surfels per work-item on " + device.info().name, light_sentence(context)};
    if (!context.needs.maps.empty())
        lines.push_back(explain_paths(context.device_scene.triangle_count, context.needs.maps,
                                      static_cast<int>(device.info().compute_units), context.prepared));
    if (!context.kernels.features().smooth)
        lines.push_back("left out: shading normals (no vertex normals in the scene): buffer, interpolation and side test");
    if (context.options.bounces == 0) lines.push_back("left out: light samples and pencils (emission only)");
    return lines;
}

}  // namespace pencil
