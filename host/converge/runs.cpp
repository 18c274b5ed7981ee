#include "converge/runs.h"

#include <fmt/format.h>

#include <cstdlib>

#include "compare/metrics.h"
#include "converge/methods.h"
#include "image/write_image.h"
#include "reference/path_tracer.h"
#include "render/render.h"
#include "scene/scene_fingerprint.h"
#include "util/stopwatch.h"

namespace pencil {
namespace {

RenderOptions render_options(const std::string& method, int budget, std::uint64_t seed, const ConvergeOptions& options) {
    RenderOptions result = find_method(method).budget(budget).options;
    result.width = options.width;
    result.height = options.height;
    result.bounces = options.bounces;
    result.seed = seed;
    result.aovs = {};
    return result;
}

/// Fills times, stages and pixels. False if interrupted.
bool render_run(RunPoint& point, std::vector<float>& rgb, const Scene& scene, const ConvergeOptions& options,
                const std::shared_ptr<Device>& device, const Progress& progress) {
    const double built = device->build_seconds();
    const Stopwatch watch;
    RenderResult result = render(scene, render_options(point.method, point.budget, point.seed, options), device, progress);
    point.build_seconds = device->build_seconds() - built;
    point.seconds = watch.seconds() - point.build_seconds;
    for (const StageTime& stage : result.stats.stages)
        if (stage.name != "kernel build") point.stages.emplace_back(stage.name, stage.wall_seconds);
    rgb = std::move(result.layers.front().pixels);
    return !result.interrupted;
}

bool trace_run(RunPoint& point, std::vector<float>& rgb, const Scene& scene, const ConvergeOptions& options, const Progress& progress) {
    TracedImage traced = trace_image(scene, options, path_tracer_seconds(point.budget), point.seed, progress);
    point.seconds = traced.seconds;
    point.stages.emplace_back("path tracing", traced.seconds);
    rgb = std::move(traced.rgb);
    return !traced.interrupted;
}

/// Over the last minute.
double machine_load() {
    double load = 0;
    return ::getloadavg(&load, 1) == 1 ? load : 0;
}

void measure_run(RunPoint& point, const std::vector<float>& rgb, const Truth& truth) {
    const Metrics metrics = measure({rgb.data(), truth.rgb.data(), rgb.size() / 3, 3}, truth.exposure);
    point.rmse = metrics.rmse;
    point.rel_mse = metrics.rel_mse;
    point.mean_ratio = metrics.mean_ratio;
    point.psnr = metrics.psnr;
    point.lab_rms = metrics.lab_rms.value_or(0);
    point.excluded_pixels = metrics.excluded;
}

}  // namespace

TracedImage trace_image(const Scene& scene, const ConvergeOptions& options, double seconds, std::uint64_t seed, const Progress& progress) {
    ReferenceOptions tracing;
    tracing.spp = 0;
    tracing.seconds = seconds;
    tracing.max_depth = options.bounces < 0 ? -1 : options.bounces + 1;
    tracing.width = options.width;
    tracing.height = options.height;
    tracing.seed = seed;
    const Stopwatch watch;
    ReferenceResult result = trace_paths(scene, tracing, progress);
    return {std::move(result.layers.front().pixels), static_cast<int>(result.spp), watch.seconds(), result.interrupted};
}

std::string run_flags(const std::string& method, int budget) {
    if (method == path_tracer_name) return fmt::format("--time {:g}", path_tracer_seconds(budget));
    return find_method(method).budget(budget).flags;
}

std::filesystem::path image_file(const ConvergeOptions& options, const std::string& method, int budget, std::uint64_t seed) {
    return options.folder / "images" / fmt::format("{}-{}-{}.exr", method, budget, seed);
}

std::optional<RunPoint> run_task(const Task& task, const Scene& scene, const ConvergeOptions& options, const Truth& truth,
                                 const std::shared_ptr<Device>& device, const Progress& progress) {
    RunPoint point;
    point.method = task.method;
    point.budget = task.budget;
    point.seed = task.seed;
    point.options = run_flags(task.method, task.budget);
    std::vector<float> rgb;
    const bool finished = task.method == path_tracer_name ? trace_run(point, rgb, scene, options, progress)
                                                          : render_run(point, rgb, scene, options, device, progress);
    if (!finished) return {};
    point.load = machine_load();
    measure_run(point, rgb, truth);
    write_image(image_file(options, task.method, task.budget, task.seed), {options.width, options.height, {{"", 3, rgb.data()}}},
                {{"Software", fmt::format("pencil {}", options.version)},
                 {"pencil:scene", options.scene.filename().string()},
                 {"pencil:sceneFingerprint", scene_fingerprint(scene)},
                 {"pencil:method", task.method},
                 {"pencil:options", point.options},
                 {"pencil:seed", std::to_string(task.seed)}});
    return point;
}

void warm_up(const Scene& scene, const ConvergeOptions& options, const std::shared_ptr<Device>& device, const Progress& progress) {
    for (const std::string& method : options.methods) render(scene, render_options(method, 0, 0, options), device, progress);
}

}  // namespace pencil
