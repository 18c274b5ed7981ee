#include "render/explain.h"

#include "pencils/light_samples.h"
#include "line/weights.h"

namespace pencil {

namespace {

std::string light_sentence(const Scene& scene, const std::vector<LightForm>& forms, Initial initial) {
    std::size_t samples = 0, maps = 0;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        if (scene.shapes[i].emits) ++(forms[i] == LightForm::maps ? maps : samples);
    std::string why = initial == Initial::automatic
                          ? " (auto: an emitter of more than " + std::to_string(static_cast<int>(100 * large_emitter)) +
                                " % of the scene's surface is carried by the maps)"
                          : " (as asked)";
    return "direct light: " + std::to_string(scene.point_lights.size()) + " point lights and " + std::to_string(samples) +
           " emitting shapes by light samples, " + std::to_string(maps) + " emitting shapes carried by the pencil maps" + why;
}

}  // namespace

std::vector<std::string> explain(const Scene& scene, const RenderOptions& options, const std::vector<LightForm>& forms,
                                 const Features& features, const std::string& maps, const Device& device) {
    std::vector<std::string> lines;
    lines.push_back("packets of " + std::to_string(device.packet_width()) + " surfels per work-item on " + device.info().name);
    lines.push_back(light_sentence(scene, forms, options.initial));
    if (!maps.empty()) lines.push_back(maps);
    if (options.method == Method::surface) {
        lines.push_back("visibility: always rays through the hierarchy; no geometry maps, so no choice among ways to make them");
        lines.push_back("indirect light: pencils on surfaces; left out: octahedral maps of pencils, density, weights, shrinking sets");
    } else {
        lines.push_back(explain_weights(features.weights, cell_grid(options.pencils)));
        lines.push_back(options.iterate == Iterate::fixed ? "iteration: one fixed set; its geometry maps and weights are made once"
                                                          : "iteration: a new, smaller set for each bounce");
    }
    if (!features.smooth)
        lines.push_back("left out: shading normals (no vertex normals in the scene): buffer, interpolation and side test");
    if (options.bounces == 0) lines.push_back("left out: light samples and pencils (emission only)");
    if (options.bounces == 1 && options.method == Method::line)
        lines.push_back("left out: all pencil sets that do not carry direct light (one reflection)");
    return lines;
}

}  // namespace pencil
