// Films, maps and options at the ends of what they may be.
#include <fmt/format.h>

#include "stress/stress_cases.h"
#include "stress/stress_render.h"
#include "stress/stress_scenes.h"
#include "util/error.h"

namespace pencil {

namespace {

using Measurements = std::vector<Measurement>;

/// A furnace of albedo 0.5 shows 2 on any film, by any options.
Measurements even_two(const StressRun& run, const RenderOptions& options, int width = 16, int height = 12) {
    return {below("largest error against 2", error_of(render(furnace_room(0.5F, width, height), options, run).layers, 2), 2e-3)};
}

StressCase film_case(MethodName method, const char* name, int width, int height) {
    return {fmt::format("film-{}x{}-{}", width, height, name),
            fmt::format("furnace of albedo 0.5 on a film of {}x{}, {} method", width, height, name),
            [=](const StressRun& run) { return even_two(run, stress_options(method), width, height); }};
}

template <typename Change>
StressCase option_case(const std::string& name, const std::string& scene, MethodName method, Change change) {
    return {name, scene,
            [=](const StressRun& run) {
                RenderOptions options = stress_options(method);
                change(options);
                return even_two(run, options);
            }};
}

/// A map of one colour is a constant environment: a floor under it shows its albedo.
Measurements small_sky(const StressRun& run, int width, int height) {
    Scene scene;
    add_floor(scene, 1, {glm::vec3(0.5F)});
    Environment sky;
    sky.width = width;
    sky.height = height;
    sky.texels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), glm::vec3(1.0F));
    scene.environment = sky;
    look(scene, {0, 1, 0.2}, {0, 0, 0}, 40, 16, 12);
    return {below("largest error", error_of(render(scene, stress_options(MethodName::surface), run).layers, 0.5), 1e-3)};
}

Measurements small_texture(const StressRun& run, int size) {
    Scene scene = furnace_room(1.0F);
    Texture texture;
    texture.width = texture.height = size;
    const std::uint16_t half = 0x3800, one = 0x3c00;  // as half floats
    texture.texels.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), glm::u16vec4(half, half, half, one));
    scene.textures.push_back(texture);
    scene.uvs.assign(scene.positions.size(), glm::vec2(0.3F, -7.2F));
    for (SceneMaterial& m : scene.materials) m.albedo_texture = 0;
    return {below("largest error against 2", error_of(render(scene, stress_options(MethodName::surface), run).layers, 2), 2e-3)};
}

/// Refused with a reason, not rendered wrongly.
Measurements refused(const StressRun& run, int map) {
    RenderOptions options = stress_options(MethodName::line);
    options.map = map;
    double said = 0;
    try {
        render(furnace_room(0.5F), options, run);
    } catch (const UsageError& error) {
        said = std::string(error.what()).find("--map") != std::string::npos ? 1 : 0;
    }
    return {near("refusals that name the option", said, 1, 0)};
}

Measurements nothing_in_view(const StressRun& run, MethodName method) {
    Scene scene = furnace_room(0.5F);
    look(scene, {100, 0, 0}, {200, 0, 0}, 40, 8, 8);
    return {below("mean", mean_of(render(scene, stress_options(method), run).layers), 0)};
}

}  // namespace

std::vector<StressCase> film_cases() {
    std::vector<StressCase> rows;
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 13}, {17, 11}}) {
        rows.push_back(film_case(MethodName::surface, "surface", width, height));
        rows.push_back(film_case(MethodName::line, "line", width, height));
        rows.push_back(film_case(MethodName::hybrid, "hybrid", width, height));
    }
    for (const int map : {1, 2})
        rows.push_back({fmt::format("map-{}", map), fmt::format("line method with maps of {} texels", map),
                        [map](const StressRun& run) { return refused(run, map); }});
    rows.push_back(
        option_case("map-8", "furnace of albedo 0.5, maps of 8 texels, the least", MethodName::line, [](RenderOptions& o) { o.map = 8; }));
    for (const int pencils : {1, 256})
        rows.push_back(option_case(fmt::format("pencils-{}-hybrid", pencils), fmt::format("the same, {} pencils and 16 rays", pencils),
                                   MethodName::hybrid, [pencils](RenderOptions& o) {
                                       o.pencils = pencils;
                                       o.map = 8;
                                       o.rays = 16;
                                   }));
    for (const int rays : {1, 576})
        rows.push_back(option_case(fmt::format("rays-{}", rays), fmt::format("the same, 4 pencils and {} rays", rays), MethodName::hybrid,
                                   [rays](RenderOptions& o) {
                                       o.pencils = 4;
                                       o.map = 8;
                                       o.rays = rays;
                                   }));
    for (const int pencils : {1, 2, 256})  // the exponent beta goes with the number of pencils: 0 for one
        rows.push_back(option_case(fmt::format("pencils-{}-line", pencils),
                                   fmt::format("furnace of albedo 0.5, {} pencils of the line method", pencils), MethodName::line,
                                   [pencils](RenderOptions& o) {
                                       o.pencils = pencils;
                                       o.map = 16;
                                   }));
    rows.push_back(option_case(
        "pencils-1-voronoi", "the same, one pencil, Voronoi weights", MethodName::line,
        [](RenderOptions& o) {
            o.pencils = 1;
            o.weights = Weights::voronoi;
        }));
    rows.push_back(option_case(
        "pencils-1-surface", "furnace of albedo 0.5, one pencil asked for, surface method", MethodName::surface,
        [](RenderOptions& o) { o.pencils = 1; }));
    rows.push_back(option_case(
        "pencils-20-surface", "the same, 20 pencils asked for", MethodName::surface, [](RenderOptions& o) { o.pencils = 20; }));
    rows.push_back(option_case(
        "film-samples-1", "the same with one visibility sample", MethodName::surface, [](RenderOptions& o) { o.film_samples = 1; }));
    rows.push_back(option_case("tolerance-1e-12", "the same, --tolerance 1e-12, below float's rounding", MethodName::surface,
                               [](RenderOptions& o) { o.tolerance = 1e-12; }));
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 2}, {2, 2}})
        rows.push_back({fmt::format("sky-{}x{}", width, height),
                        fmt::format("floor of albedo 0.5 under a map of {}x{} texels of 1", width, height),
                        [width = width, height = height](const StressRun& run) { return small_sky(run, width, height); }});
    for (const int size : {1, 2})
        rows.push_back({fmt::format("texture-{}", size), fmt::format("furnace with a texture of {}x{} texels of 0.5", size, size),
                        [size](const StressRun& run) { return small_texture(run, size); }});
    rows.push_back({"nothing-in-view", "furnace behind the eye, surface method",
                    [](const StressRun& run) { return nothing_in_view(run, MethodName::surface); }});
    rows.push_back({"nothing-in-view-line", "furnace behind the eye, line method",
                    [](const StressRun& run) { return nothing_in_view(run, MethodName::line); }});
    rows.push_back({"nothing-in-view-hybrid", "furnace behind the eye, lines and rays",
                    [](const StressRun& run) { return nothing_in_view(run, MethodName::hybrid); }});
    return rows;
}

}  // namespace pencil
