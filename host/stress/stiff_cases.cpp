// Albedos near 1: light is reflected hundreds of times, and the sum of all reflections is a stiff linear system.
#include <fmt/format.h>

#include <cmath>

#include "stress/stress_cases.h"
#include "stress/stress_render.h"
#include "stress/stress_scenes.h"

namespace pencil {

namespace {

using Measurements = std::vector<Measurement>;

double applications(const RenderResult& result) { return result.stats.bounce_solve.steps + result.stats.bounce_solve.krylov; }

/// Albedo, and the most applications of transport between pencils that its light may cost.
struct Stiffness {
    const char* albedo;
    int applications;
};
constexpr Stiffness stiff[] = {{"0.99", 40}, {"0.999", 80}, {"0.9999", 160}};

/// Enough pencils to know the mean to half a percent.
RenderOptions fine_options() {
    RenderOptions options = stress_options(MethodName::surface);
    options.pencils = standard_pencils(MethodName::surface);
    return options;
}

/// As float holds it.
double rounded(const char* albedo) { return static_cast<double>(std::stof(albedo)); }

Measurements furnace(const StressRun& run, const Stiffness& s) {
    const RenderResult result = render(furnace_room(std::stof(s.albedo)), stress_options(MethodName::surface), run);
    return {near("mean over truth", mean_of(result.layers) * (1 - rounded(s.albedo)), 1, 0.005),
            below("largest error", error_of(result.layers, 1 / (1 - rounded(s.albedo))), 0.01),
            below("applications of transport", applications(result), s.applications)};
}

Measurements cube(const StressRun& run, const Stiffness& s) {
    const RenderResult result = render(lit_cube(std::stof(s.albedo)), fine_options(), run);
    return {near("mean over truth", mean_of(result.layers) / lit_cube_answer(rounded(s.albedo)), 1, 0.005),
            below("applications of transport", applications(result), s.applications)};
}

/// A lamp that reflects as the walls do, on both sides. Light that was reflected a few times is the path tracer's; the rest is even, by the balance of
/// energy: each reflection sends on a share `albedo` of what all surfaces have.
Measurements lamp(const StressRun& run, const Stiffness& s) {
    const glm::vec3 albedo(std::stof(s.albedo));
    Scene scene;
    add_room(scene, glm::dvec3(0), {2, 1, 1}, {albedo});
    add_sheet(scene, {0.45, 0.9, 0.45}, {0.1, 0, 0}, {0, 0, 0.1}, {albedo, glm::vec3(1.0F), true});
    look(scene, {0.1, 0.5, 0.1}, {1.5, 0.3, 0.9}, 90, 16, 12);
    constexpr int uneven = 10;  // reflections
    constexpr double lamp = 0.01, surface = 10 + 2 * lamp;
    ReferenceOptions paths;
    paths.spp = 512;
    paths.max_depth = uneven + 1;
    const double a = rounded(s.albedo), even = std::pow(a, uneven + 1) / (1 - a) * lamp / surface;
    const double truth = mean_of(trace_paths(scene, paths, run).layers) + even;
    const RenderResult result = render(scene, fine_options(), run);
    return {near("mean over truth", mean_of(result.layers) / truth, 1, 0.005),
            below("applications of transport", applications(result), s.applications)};
}

/// Closed and without loss: no sum exists.
Measurements without_sum(const StressRun& run, const Scene& scene, MethodName method) {
    RenderOptions options = stress_options(method);
    if (method != MethodName::surface) options.pencils = 16, options.map = 8;
    const RenderResult result = render(scene, options, run);
    return {below("values that are not finite", non_finite_of(result.layers), 0),
            below("said to have converged", result.stats.converged ? 1 : 0, 0),
            {"warnings", static_cast<double>(result.stats.warnings.size()), 1, 9}};
}

/// Without a limit there is no sum, with one there is.
Measurements three_reflections(const StressRun& run) {
    RenderOptions options = stress_options(MethodName::surface);
    options.bounces = 3;
    return {below("largest error against 4", error_of(render(furnace_room(1.0F), options, run).layers, 4), 1e-3)};
}

/// White walls with an open side: every reflection loses what leaves, so there is a sum. The room is a well 1 wide and `depth` deep under a
/// sky of radiance 1 whose walls and floor reflect all: the radiance is 1 everywhere (no light is lost, so entropy has it nowhere else to go).
Measurements white_well(const StressRun& run, double depth) {
    Scene scene;
    add_room(scene, {0, -depth, 0}, {1, 0, 1}, {glm::vec3(1.0F)});
    scene.triangles.erase(scene.triangles.begin() + 6, scene.triangles.begin() + 8);  // its lid: axis y, side high
    scene.environment = Environment{};
    look(scene, {0.5, -0.5 * depth, 0.5}, {0.5, -depth, 0.5001}, 80, 16, 16);
    const RenderResult result = render(scene, stress_options(MethodName::surface), run);
    return {near("mean over truth", mean_of(result.layers), 1, 0.005),
            near("said to have converged", result.stats.converged ? 1 : 0, 1, 0)};
}

/// Red light is kept, green is lost half of the time, blue always.
Measurements one_colour_stiff(const StressRun& run) {
    Scene scene;
    add_room(scene, {-1, -1, -1}, {1.5, 1, 1}, {{0.9999F, 0.5F, 0.0F}, glm::vec3(1.0F)});
    look(scene, {-0.7, 0.2, 0.6}, {1.2, -0.3, -0.8}, 90, 16, 12);
    const std::vector<float> pixels = render(scene, stress_options(MethodName::surface), run).layers.front().pixels;
    glm::dvec3 mean(0);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        mean[static_cast<int>(i % 3)] += 3.0 * static_cast<double>(pixels[i]) / static_cast<double>(pixels.size());
    return {near("red over truth", mean.x * (1 - rounded("0.9999")), 1, 0.005), near("green", mean.y, 2, 1e-3),
            near("blue", mean.z, 1, 1e-6)};
}

Measurements line_furnace(const StressRun& run, float albedo, MethodName method = MethodName::line) {
    RenderOptions options = stress_options(method);
    options.pencils = 16;
    options.map = 8;
    const RenderResult result = render(furnace_room(albedo), options, run);
    const double over_truth = mean_of(result.layers) * (1 - static_cast<double>(albedo));
    // What is wrong is said to be, and is too little: a part of the sum.
    return {below("error of the mean, 0 if it is said not to have converged", result.stats.converged ? std::abs(over_truth - 1) : 0, 0.02),
            below("mean over truth", over_truth, 1.02), below("values that are not finite", non_finite_of(result.layers), 0)};
}

}  // namespace

std::vector<StressCase> stiff_cases() {
    std::vector<StressCase> rows;
    const auto add = [&rows](const char* name, const char* scene, Measurements (*measure)(const StressRun&, const Stiffness&)) {
        for (const Stiffness& s : stiff)
            rows.push_back({fmt::format("{}-{}", name, s.albedo), fmt::format(fmt::runtime(scene), s.albedo),
                            [measure, s](const StressRun& run) { return measure(run, s); }});
    };
    add("furnace", "closed box, all walls emit 1, albedo {}", furnace);
    add("lit-cube", "closed cube, point light in its middle, albedo {}", cube);
    add("small-lamp", "closed room, lamp of a thousandth of its surface, all of albedo {}", lamp);
    rows.push_back({"one-colour-stiff", "furnace of albedo 0.9999 in red, 0.5 in green, 0 in blue", one_colour_stiff});
    rows.push_back({"furnace-1", "furnace of albedo 1: light without end",
                    [](const StressRun& run) { return without_sum(run, furnace_room(1.0F), MethodName::surface); }});
    rows.push_back({"lit-cube-1", "closed cube of albedo 1, point light in its middle",
                    [](const StressRun& run) { return without_sum(run, lit_cube(1.0F), MethodName::surface); }});
    rows.push_back({"furnace-1-three-reflections", "the furnace of albedo 1 with --bounces 3: 1 + 1 + 1 + 1", three_reflections});
    rows.push_back({"white-well-1", "well 1 wide and 1 deep, albedo 1, under a sky of 1: all of it shows 1",
                    [](const StressRun& run) { return white_well(run, 1); }});
    rows.push_back({"white-well-10", "the same, 10 deep", [](const StressRun& run) { return white_well(run, 10); }});
    rows.push_back(
        {"line-furnace-0.99", "furnace of albedo 0.99, line method", [](const StressRun& run) { return line_furnace(run, 0.99F); }});
    rows.push_back({"hybrid-furnace-0.99", "furnace of albedo 0.99, lines and rays",
                    [](const StressRun& run) { return line_furnace(run, 0.99F, MethodName::hybrid); }});
    rows.push_back({"line-furnace-0.9999", "furnace of albedo 0.9999, line method: 512 sets say that they are not enough",
                    [](const StressRun& run) { return line_furnace(run, 0.9999F); }});
    rows.push_back({"line-furnace-1", "furnace of albedo 1, line method",
                    [](const StressRun& run) { return without_sum(run, furnace_room(1.0F), MethodName::line); }});
    for (std::size_t i = rows.size() - 2; i < rows.size(); ++i) rows[i].quick = false;  // hundreds of sets
    return rows;
}

}  // namespace pencil
