// Scales, slivers, dust, coincidence, and places where no light is.
#include <fmt/format.h>

#include <cmath>

#include "reference/path_tracer.h"
#include "stress/geometry_scenes.h"
#include "stress/stress_cases.h"
#include "stress/stress_render.h"
#include "stress/stress_scenes.h"
#include "util/constants.h"

namespace pencil {

namespace {

using Measurements = std::vector<Measurement>;

constexpr float grey = 0.5F;

constexpr const char* of_truth = "mean over truth";

/// What a furnace of albedo 0.5 shows everywhere.
Measurements even_two(const StressRun& run, const Scene& scene, const RenderOptions& options) {
    const RenderResult result = render(scene, options, run);
    return {near(of_truth, mean_of(result.layers) / 2, 1, 0.002), below("largest error", error_of(result.layers, 2), 0.02),
            below("passes", result.stats.passes, 16)};
}

Measurements dust(const StressRun& run, std::size_t count, double size) {
    RenderOptions options = stress_options(MethodName::surface);
    options.target_error = 1e-3;
    return even_two(run, dust_scene(count, size), options);
}

/// A floor of squares one in the other, each ten times as wide as the last, under a sky of radiance 1: a floor sees nothing else.
Measurements twelve_decades(const StressRun& run) {
    const Scene scene = decades_scene();
    const RenderResult result = render(scene, stress_options(MethodName::surface), run);
    return {below("largest error", error_of(result.layers, grey), 1e-3)};
}

/// A point light so near a floor that half of its light falls on a spot, seen by what the spot sends to a small ceiling 1 above it. There,
/// irradiance is that of the light and of the floor, I d / (d^2 + r^2)^(3/2) at distance r from below the light.
/// The mean of so many renders: few rays meet what is lit from so near.
Measurements near_a_wall(const StressRun& run, double d, int renders) {
    const Scene scene = near_floor_scene(d);
    double floor = 0;
    constexpr int steps = 200000;
    for (int k = 0; k < steps; ++k) {  // even steps of the share of the light within r
        const double share = (k + 0.5) / steps, r2 = d * d * (1 / (share * share) - 1);
        floor += grey / pi * 2 * pi / ((1 + r2) * (1 + r2)) / steps;
    }
    RenderOptions options = stress_options(MethodName::surface);
    options.bounces = 2;
    options.target_error = 1e-4;
    const double truth = grey / pi * (1 / ((1 - d) * (1 - d)) + floor);
    double mean = 0;
    for (int k = 0; k < renders; ++k, ++options.seed) mean += mean_of(render(scene, options, run).layers) / renders;
    return {near(of_truth, mean / truth, 1, 0.01)};
}

/// The floor from so low that it is seen as a line: half of the film is floor, half is sky.
Measurements grazing(const StressRun& run, double height) {
    Scene scene;
    add_floor(scene, 1000, {glm::vec3(grey)});
    scene.environment = Environment{};
    look(scene, {0, height, 0}, {1, height, 0.1}, 60, 16, 16);
    return {near(of_truth, mean_of(render(scene, stress_options(MethodName::surface), run).layers) / 0.75, 1, 1e-3)};
}

/// Of surfaces in one plane, the first in the file is seen.
Measurements coincident(const StressRun& run, MethodName method) {
    Scene scene;
    for (const float albedo : {0.2F, 0.8F, 0.4F}) add_floor(scene, 1, {glm::vec3(albedo)});
    scene.point_lights.push_back({{0, 1, 0}, glm::vec3(1.0F)});
    look(scene, {0, 1, 0.2}, {0, 0, 0}, 50, 16, 12);
    RenderOptions options = stress_options(method);
    options.aovs = {"albedo"};
    double error = 1;
    for (const Layer& layer : render(scene, options, run).layers)
        if (layer.name == albedo_layer) error = error_of({layer}, static_cast<double>(0.2F));
    return {below("largest error of the albedo", error, 1e-6)};
}

Scene moved(Scene scene, double scale, const glm::dvec3& offset) {
    for (glm::dvec3& p : scene.positions) p = scale * p + offset;
    scene.sensor.to_world[3] = glm::dvec4(scale * glm::dvec3(scene.sensor.to_world[3]) + offset, 1);
    scene.sensor.near_clip *= scale;
    scene.sensor.far_clip *= scale;
    return scene;
}

Measurements somewhere_else(const StressRun& run, double scale, double offset, double tolerance) {
    const RenderOptions options = stress_options(MethodName::surface);
    const double here = mean_of(render(furnished_room(), options, run).layers),
                 there = mean_of(render(moved(furnished_room(), scale, glm::dvec3(offset, -offset, offset)), options, run).layers);
    return {near("mean over that at the origin", there / here, 1, tolerance)};
}

/// An image that may be wrong, but not in silence: what light paths say of its mean is the truth, and a warning says that it is wrong.
Measurements wrong_but_known(const RenderResult& result, double truth, double noise) {
    const CertifiedError& found = result.stats.certified;
    const auto says = [](const std::string& warning) { return warning.find("find the image's mean wrong") != std::string::npos; };
    const std::vector<std::string>& warnings = result.stats.warnings;
    const double mean = mean_of(result.layers), error = mean * found.mean_error + noise;
    return {
        below("mean that light paths find, less the truth, in standard errors", std::abs(mean * (1 - found.mean_bias) - truth) / error, 4),
        below("standard error of what they find, over the image's mean", found.mean_error, 0.25),
        {"said to be wrong", std::any_of(warnings.begin(), warnings.end(), says) ? 1.0 : 0.0, 1, 1}};
}

/// Against the path tracer, which knows the mean to some percent here.
Measurements dark_maze(const StressRun& run, MethodName method) {
    const Scene scene = maze();
    ReferenceOptions reference;
    reference.spp = 1 << 16;
    RenderOptions options = stress_options(method);
    options.target_error = 1e-3;
    const double truth = mean_of(trace_paths(scene, reference, run).layers);
    const RenderResult result = render(scene, options, run);
    if (method == MethodName::surface) return {near("mean over the path tracer's", mean_of(result.layers) / truth, 1, 0.1)};
    return wrong_but_known(result, truth, 0.03 * truth);
}

/// Film and eye in a closed box, light of about 1 around it.
Measurements dark_inside(const StressRun& run, MethodName method, const Scene& scene) {
    const RenderResult result = render(scene, stress_options(method), run);
    if (method == MethodName::surface) return {below("mean", mean_of(result.layers), 1e-4)};
    return wrong_but_known(result, 0, 1e-4);
}

Measurements light_on_the_floor(const StressRun& run, double height) {
    Scene scene;
    add_floor(scene, 1, {glm::vec3(grey)});
    scene.point_lights.push_back({{0.1, height, 0.1}, glm::vec3(1.0F)});
    look(scene, {0, 1, 0.3}, {0, 0, 0}, 60, 16, 12);
    return {below("values that are not finite", non_finite_of(render(scene, stress_options(MethodName::surface), run).layers), 0)};
}

}  // namespace

std::vector<StressCase> geometry_cases() {
    const auto row = [](const std::string& name, const std::string& scene, std::function<Measurements(const StressRun&)> run) {
        return StressCase{name, scene, std::move(run)};
    };
    StressCase maze_surface = row("maze-surface", "four rooms in a row, lamp in the first, eye in the last, surface method",
                                  [](const StressRun&d) { return dark_maze(d, MethodName::surface); }),
               maze_line = row("maze-line", "the same, line method", [](const StressRun&d) { return dark_maze(d, MethodName::line); });
    maze_surface.quick = maze_line.quick = false;
    return {
        maze_surface,
        maze_line,
        row("dust-1e-9", "furnace of albedo 0.5 with 1000 white triangles of 1e-9, below float's resolution",
            [](const StressRun& d) { return dust(d, 1000, 1e-9); }),
        row("dust-1e-7", "the same of 1e-7, some steps of float wide", [](const StressRun& d) { return dust(d, 1000, 1e-7); }),
        row("dust-1e-3", "the same of 1e-3", [](const StressRun& d) { return dust(d, 1000, 1e-3); }),
        row("needles", "the same furnace with 500 white needles, a millionth as wide as long",
            [](const StressRun& d) { return even_two(d, needle_scene(), stress_options(MethodName::surface)); }),
        row("twelve-decades", "floor of squares from 1e-6 to 1e6, one in the other, under a sky of 1", twelve_decades),
        row("point-light-1e-2", "point light 1e-2 from a floor, seen by what the floor reflects",
            [](const StressRun& d) { return near_a_wall(d, 1e-2, 6); }),
        row("point-light-1e-4", "the same, 1e-4 from it", [](const StressRun& d) { return near_a_wall(d, 1e-4, 30); }),
        row("point-light-0", "point light in the plane of a floor", [](const StressRun& d) { return light_on_the_floor(d, 0); }),
        row("point-light-1e-9", "point light 1e-9 over a floor", [](const StressRun& d) { return light_on_the_floor(d, 1e-9); }),
        row("grazing-1e-2", "floor under a sky of 1, seen from 1e-2 above", [](const StressRun& d) { return grazing(d, 1e-2); }),
        row("grazing-1e-5", "the same from 1e-5 above", [](const StressRun& d) { return grazing(d, 1e-5); }),
        row("coincident-surface", "three floors in one plane, surface method",
            [](const StressRun& d) { return coincident(d, MethodName::surface); }),
        row("coincident-line", "three floors in one plane, line method",
            [](const StressRun& d) { return coincident(d, MethodName::line); }),
        row("coincident-hybrid", "three floors in one plane, lines and rays",
            [](const StressRun& d) { return coincident(d, MethodName::hybrid); }),
        row("unit-1e6", "furnished room a million times as large", [](const StressRun& d) { return somewhere_else(d, 1e6, 0, 1e-3); }),
        row("unit-1e-6", "furnished room a million times as small", [](const StressRun& d) { return somewhere_else(d, 1e-6, 0, 1e-3); }),
        row("unit-1e-30", "furnished room of 1e-30", [](const StressRun& d) { return somewhere_else(d, 1e-30, 0, 1e-3); }),
        row("origin-1e5", "furnished room at 1e5 from the origin", [](const StressRun& d) { return somewhere_else(d, 1, 1e5, 1e-3); }),
        row("origin-1e7", "furnished room at 1e7 from the origin", [](const StressRun& d) { return somewhere_else(d, 1, 1e7, 1e-3); }),
        row("millimetre-in-kilometre", "eye in a closed box of 1 mm on a lit floor of 1 km",
            [](const StressRun& d) { return dark_inside(d, MethodName::surface, millimetre_box()); }),
        row("eye-in-a-sphere-surface", "eye in a closed two-sided sphere in a lit room, surface method",
            [](const StressRun& d) { return dark_inside(d, MethodName::surface, eye_in_a_sphere()); }),
        row("eye-in-a-sphere-line", "the same, line method",
            [](const StressRun& d) { return dark_inside(d, MethodName::line, eye_in_a_sphere()); }),
        row("eye-in-a-sphere-hybrid", "the same, lines and rays",
            [](const StressRun& d) { return dark_inside(d, MethodName::hybrid, eye_in_a_sphere()); }),
    };
}

}  // namespace pencil
