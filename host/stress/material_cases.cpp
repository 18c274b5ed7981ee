// Surfaces at the ends of their parameters. What loses no light shows in a furnace what the furnace shows: 2 at an albedo of 0.5.
#include <fmt/format.h>

#include "stress/stress_cases.h"
#include "stress/stress_render.h"
#include "stress/stress_scenes.h"

namespace pencil {

namespace {

using Measurements = std::vector<Measurement>;

/// A pane of a material across the view.
Scene pane(const SceneMaterial& material) {
    Scene scene = furnace_room(0.5F);
    add_sheet(scene, {0.3, -0.6, 0.5}, {0.4, 0, -1.0}, {0, 1.2, 0}, {});
    scene.materials.back() = material;
    return scene;
}

Measurements invisible(const StressRun& run, const SceneMaterial& material, double tolerance) {
    const RenderResult result = render(pane(material), stress_options(MethodName::surface), run);
    return {near("mean over truth", mean_of(result.layers) / 2, 1, tolerance),
            below("values that are not finite", non_finite_of(result.layers), 0)};
}

/// Models that lose light at some angles: what paths find.
Measurements as_traced(const StressRun& run, const SceneMaterial& material) {
    const RenderResult result = render(pane(material), stress_options(MethodName::surface), run);
    ReferenceOptions reference;
    reference.spp = 1024;
    const double truth = mean_of(trace_paths(pane(material), reference, run).layers);
    return {near("mean over the path tracer's", mean_of(result.layers) / truth, 1, 0.01),
            below("values that are not finite", non_finite_of(result.layers), 0)};
}

SceneMaterial dielectric(float eta, bool thin) {
    SceneMaterial m;
    m.model = MATERIAL_DIELECTRIC;
    m.eta = glm::vec3(eta);
    m.thin = thin;
    m.albedo = glm::vec3(0);
    return m;
}

SceneMaterial conductor(float alpha) {
    SceneMaterial m;
    m.model = MATERIAL_CONDUCTOR;
    m.perfect_mirror = true;
    m.two_sided = true;
    m.albedo = glm::vec3(0);
    m.alpha = glm::vec2(alpha);
    return m;
}

SceneMaterial phong(float exponent) {
    SceneMaterial m;
    m.model = MATERIAL_PHONG;
    m.two_sided = true;
    m.albedo = glm::vec3(0.3F);
    m.specular = glm::vec3(0.5F);
    m.exponent = exponent;
    return m;
}

SceneMaterial principled(float metallic, float alpha) {
    SceneMaterial m;
    m.model = MATERIAL_PRINCIPLED;
    m.two_sided = true;
    m.albedo = glm::vec3(0.8F);
    m.alpha = glm::vec2(alpha);
    m.principled.metallic = metallic;
    return m;
}

}  // namespace

std::vector<StressCase> material_cases() {
    std::vector<StressCase> rows;
    const auto exact = [&](const std::string& name, const std::string& scene, const SceneMaterial& m, double tolerance) {
        rows.push_back({name, "furnace of albedo 0.5 with a pane: " + scene,
                        [m, tolerance](const StressRun& run) { return invisible(run, m, tolerance); }});
    };
    exact("glass-1", "glass of index 1, which is nothing", dielectric(1.0F, false), 1e-3);
    exact("glass-thin-1000", "thin glass of index 1000", dielectric(1000.0F, true), 1e-2);
    exact("mirror", "a perfect mirror", conductor(0.0F), 1e-2);
    exact("mirror-1e-4", "a perfect mirror of roughness 1e-4", conductor(1e-4F), 1e-2);
    for (const float exponent : {0.0F, 1.0F, 1e3F, 1e6F})
        rows.push_back({fmt::format("phong-{:g}", static_cast<double>(exponent)),
                        fmt::format("furnace of albedo 0.5 with a pane: Phong of exponent {:g}", static_cast<double>(exponent)),
                        [exponent](const StressRun& run) { return as_traced(run, phong(exponent)); }});
    for (const auto& [metallic, alpha] : {std::pair{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}})
        rows.push_back(
            {fmt::format("principled-{:g}-{:g}", static_cast<double>(metallic), static_cast<double>(alpha)),
             fmt::format("furnace of albedo 0.5 with a pane: principled, metallic {:g}, roughness {:g}", static_cast<double>(metallic),
                         static_cast<double>(alpha)),
             [metallic = metallic, alpha = alpha](const StressRun& run) { return as_traced(run, principled(metallic, alpha)); }});
    return rows;
}

}  // namespace pencil
