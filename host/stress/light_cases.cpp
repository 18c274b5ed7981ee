// Strength of light: radiance is linear in the emitters, whatever the exponent.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/path_tracer.h"
#include "stress/stress_cases.h"
#include "stress/stress_render.h"
#include "stress/stress_scenes.h"

namespace pencil {

namespace {

using Measurements = std::vector<Measurement>;

Scene dimmed(Scene scene, double factor) {
    const auto times = [factor](glm::vec3& v) { v = glm::vec3(glm::dvec3(v) * factor); };
    for (Shape& shape : scene.shapes) times(shape.radiance);
    for (PointLight& light : scene.point_lights) times(light.intensity);
    for (DirectionalLight& light : scene.directional_lights) times(light.irradiance);
    if (scene.environment) times(scene.environment->radiance);
    return scene;
}

/// The image of a scene with all lights times `factor` is `factor` times the image, up to the rounding of the lights themselves.
Measurements linear(const StressRun& run, const Scene& scene, MethodName method, double factor, double tolerance) {
    RenderOptions options = stress_options(method);
    options.bounces = method == MethodName::surface ? endless_bounces : 3;
    const RenderResult plain = render(scene, options, run), other = render(dimmed(scene, factor), options, run);
    return {below("difference from the image of radiance 1, scaled", difference_of(other.layers, plain.layers, factor), tolerance)};
}

Measurements linear_reference(const StressRun& run, const Scene& scene, double factor) {
    ReferenceOptions options;
    options.spp = 4;
    const ReferenceResult plain = trace_paths(scene, options, run), other = trace_paths(dimmed(scene, factor), options, run);
    return {below("difference from the image of radiance 1, scaled", difference_of(other.layers, plain.layers, factor), 1e-5)};
}

StressCase linear_case(const std::string& method, MethodName name, const std::string& factor) {
    return {fmt::format("radiance-{}-{}", factor, method), fmt::format("furnished room, lamp times {}, {} method", factor, method),
            [name, factor](const StressRun& run) { return linear(run, furnished_room(), name, std::stod(factor), 1e-5); }};
}

StressCase reference_case(const std::string& factor) {
    return {fmt::format("radiance-{}-reference", factor), fmt::format("furnished room, lamp times {}, path tracer", factor),
            [factor](const StressRun& run) { return linear_reference(run, furnished_room(), std::stod(factor)); }};
}

/// Every kind of emitter at once.
Scene all_emitters() {
    Scene scene = furnished_room();
    scene.triangles.erase(scene.triangles.begin(), scene.triangles.begin() + 2);  // one wall is open to the sky
    scene.environment = Environment{};
    scene.point_lights.push_back({{0.3, 0.7, 0.4}, glm::vec3(0.2F)});
    scene.directional_lights.push_back({glm::normalize(glm::dvec3(1, -0.5, 0.2)), glm::vec3(2.0F)});
    return scene;
}

/// Values beyond float's range become its largest number, and a warning says how many.
Measurements beyond_float(const StressRun& run) {
    Scene scene = dimmed(furnace_room(0.9F), 1e38);
    const RenderResult result = render(scene, stress_options(MethodName::surface), run);
    const auto says = [](const std::string& w) { return w.find("too large for float") != std::string::npos; };
    const auto said = std::count_if(result.stats.warnings.begin(), result.stats.warnings.end(), says);
    return {below("values that are not finite", non_finite_of(result.layers), 0),
            near("mean over float's largest", mean_of(result.layers) / static_cast<double>(std::numeric_limits<float>::max()), 1, 1e-6),
            near("warnings that say so", static_cast<double>(said), 1, 0)};
}

/// Two closed rooms, the film in one; the other's lamp is `factor` times as strong and must not matter.
Measurements beside_a_sun(const StressRun& run, double factor) {
    const auto rooms = [](double other) {
        Scene scene = furnished_room();
        Scene far = dimmed(furnished_room(), other);
        const auto shapes = static_cast<std::uint32_t>(scene.shapes.size()), rows = static_cast<std::uint32_t>(scene.materials.size());
        const auto points = static_cast<std::uint32_t>(scene.positions.size());
        for (const glm::dvec3& p : far.positions) scene.positions.push_back(p + glm::dvec3(3, 0, 0));
        scene.normals.resize(scene.positions.size(), glm::vec3(0));
        for (Triangle3 t : far.triangles) {
            t.corners += glm::uvec3(points);
            t.shape += shapes;
            t.material += rows;
            scene.triangles.push_back(t);
        }
        scene.shapes.insert(scene.shapes.end(), far.shapes.begin(), far.shapes.end());
        scene.materials.insert(scene.materials.end(), far.materials.begin(), far.materials.end());
        return scene;
    };
    RenderOptions options = stress_options(MethodName::surface);
    options.light_samples = 256;
    options.target_error = 1e-3;  // what is drawn seldom is noise of the first passes
    const double alone = mean_of(render(rooms(1), options, run).layers), beside = mean_of(render(rooms(factor), options, run).layers);
    return {near("mean over that with equal lamps", beside / alone, 1, 0.05)};
}

}  // namespace

std::vector<StressCase> light_cases() {
    std::vector<StressCase> rows;
    for (const char* factor : {"1e30", "1e-30", "1e35"}) rows.push_back(linear_case("surface", MethodName::surface, factor));
    for (const char* factor : {"1e30", "1e-30"}) {
        rows.push_back(linear_case("line", MethodName::line, factor));
        rows.push_back(linear_case("hybrid", MethodName::hybrid, factor));
    }
    for (const char* factor : {"1e30", "1e-30"}) rows.push_back(reference_case(factor));
    for (const int exponent : {100, -100})
        rows.push_back({fmt::format("radiance-2^{}", exponent), fmt::format("furnished room, lamp times 2^{}: the same bits", exponent),
                        [exponent](const StressRun& run) {
                            return linear(run, furnished_room(), MethodName::surface, std::ldexp(1.0, exponent), 0);
                        }});
    rows.push_back({"radiance-1e-40", "furnished room, lamp times 1e-40, below float's normal numbers",
                    [](const StressRun& run) {
                        // Of 1e-39 float holds 13 bits where it is written, and as many where it is read.
                        return linear(run, furnished_room(), MethodName::surface, 1e-40, 2e-3);
                    }});
    rows.push_back({"all-emitters-1e30", "room with lamp, point light, sun and sky, all times 1e30",
                    [](const StressRun& run) { return linear(run, all_emitters(), MethodName::surface, 1e30, 1e-5); }});
    rows.push_back({"all-emitters-1e-30", "the same times 1e-30",
                    [](const StressRun& run) { return linear(run, all_emitters(), MethodName::surface, 1e-30, 1e-5); }});
    rows.push_back({"beyond-float", "furnace of radiance 1e38, albedo 0.9: the answer is 1e39", beyond_float});
    for (const char* factor : {"1e2", "1e8", "1e20"})
        rows.push_back({fmt::format("other-lamp-{}", factor),
                        fmt::format("two closed rooms, the lamp of the other {} times as strong", factor),
                        [factor](const StressRun& run) { return beside_a_sun(run, std::stod(factor)); }});
    return rows;
}

}  // namespace pencil
