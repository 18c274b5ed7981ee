#include "reference/path_tracer.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>

#include "options/scale_light.h"
#include "reference/camera_rays.h"
#include "reference/film_sums.h"
#include "reference/pencil_rays.h"
#include "reference/sample_plan.h"
#include "reference/sensor_receivers.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr int tile_width = 16;  // pixels: neighbouring paths meet the same parts of the BVH

struct Tile {
    int x, y, width, height;
    int samples = 0, set_samples = 0, sets = 0;  // per pixel: in all, in the set that has begun, sets ended
};

class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

std::vector<Tile> make_tiles(int width, int height) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += tile_width)
        for (int x = 0; x < width; x += tile_width)
            tiles.push_back({x, y, std::min(tile_width, width - x), std::min(tile_width, height - y)});
    return tiles;
}

ReferenceOptions resolved(ReferenceOptions options, const Scene& scene) {
    const PerspectiveSensor& sensor = scene.sensor;
    const bool crop = sensor.crop_width > 0 && sensor.crop_height > 0;
    if (!scene.sensor_points.empty()) {
        options.width = static_cast<int>(scene.sensor_points.size());
        options.height = 1;
    }
    if (options.field) {
        options.width = options.field->width();
        options.height = options.field->height();
    }
    if (options.width <= 0) options.width = crop ? sensor.crop_width : sensor.width;
    if (options.height <= 0) options.height = crop ? sensor.crop_height : sensor.height;
    if (options.max_depth == depth_of_scene) options.max_depth = scene.max_depth;
    if (options.max_depth == 0 || options.max_depth < -1) throw UsageError("the depth of paths must be -1 or at least 1");
    if (options.seconds <= 0 && options.spp < 1) throw UsageError("at least one path per pixel is needed");
    if (options.threads < 0) throw UsageError("the number of threads must not be negative");
    return options;
}

/// Tells how far the work is, and whether it is to go on.
class Reporter {
public:
    explicit Reporter(const ReferenceProgress& progress) : progress_(progress) {}

    void report(const std::string& stage, double fraction) {
        const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
        if (!progress_ || !lock || stopped_) return;
        if (!progress_(stage, std::clamp(fraction, 0.0, 1.0))) stopped_ = true;
    }
    bool stopped() const { return stopped_; }

private:
    const ReferenceProgress& progress_;
    std::mutex mutex_;
    std::atomic<bool> stopped_{false};
};

class PathTracer {
public:
    PathTracer(const Scene& scene, const ReferenceOptions& options, const ReferenceProgress& progress)
        : options_(resolved(options, scene)),
          reporter_(progress),
          scene_(begin_build(scene)),
          emitters_(scene, scene_),
          integrator_(scene_, emitters_, options_.max_depth),
          sensors_(scene, scene_),
          camera_(scene.sensor, scene_, options_.width, options_.height),
          eye_(scene.sensor.to_world[3]),
          film_(options_.width, options_.height, options_),
          tiles_(make_tiles(options_.width, options_.height)) {
        result_.build_seconds = build_watch_.seconds();
    }

    ReferenceResult run() {
        SamplePlan plan(options_);
        const Stopwatch watch;
        tbb::task_arena arena(options_.threads > 0 ? options_.threads : tbb::task_arena::automatic);
        for (SamplePlan::Pass pass = plan.next(0); pass.samples > 0 && !reporter_.stopped(); pass = plan.next(watch.seconds()))
            arena.execute([&] { trace_pass(pass, plan, watch); });
        result_.trace_seconds = watch.seconds();
        return finish();
    }

private:
    const Scene& begin_build(const Scene& scene) {
        build_watch_ = {};
        reporter_.report("build BVH", 0);
        return scene;
    }

    void trace_pass(const SamplePlan::Pass& pass, const SamplePlan& plan, const Stopwatch& watch) {
        std::atomic<std::size_t> done{0};
        const auto count = static_cast<double>(tiles_.size());
        tbb::parallel_for(
            std::size_t{0}, tiles_.size(),
            [&](std::size_t i) {
                if (reporter_.stopped()) return;
                trace_tile(pass, tiles_[i]);
                reporter_.report("trace paths", plan.fraction(static_cast<double>(++done) / count, watch.seconds()));
            },
            tbb::simple_partitioner());
    }

    void trace_tile(const SamplePlan::Pass& pass, Tile& tile) {
        std::uint64_t rays = 0, dropped = 0, cut = 0;
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x) {
                PathSums paths;
                SurfaceSums surfaces;
                trace_pixel(pass, x, y, paths, surfaces);
                film_.add(index(x, y), paths, surfaces);
                if (pass.ends_set) film_.end_set(index(x, y), tile.set_samples + pass.samples);
                rays += paths.rays;
                dropped += paths.dropped;
                cut += paths.cut;
            }
        tile.samples += pass.samples;
        tile.set_samples = pass.ends_set ? 0 : tile.set_samples + pass.samples;
        tile.sets += pass.ends_set ? 1 : 0;
        rays_ += rays;
        dropped_ += dropped;
        cut_ += cut;
    }

    void trace_pixel(const SamplePlan::Pass& pass, int x, int y, PathSums& paths, SurfaceSums& surfaces) const {
        const std::uint64_t seed = mix_bits(mix_bits(mix_bits(options_.seed) + static_cast<std::uint64_t>(pass.set)) ^ index(x, y));
        for (int s = 0; s < pass.samples; ++s) {
            Sampler sampler(seed, static_cast<std::uint32_t>(pass.first + s));
            if (!sensors_.empty()) {
                integrator_.trace_receiver(sensors_.at(index(x, y), sampler), 1.0F, sampler, paths);
                continue;
            }
            if (options_.field) {
                const Ray ray = pencil_ray(*options_.field, scene_, x, y, sampler);
                integrator_.trace(ray, ray.length > 0, 1.0F, sampler, paths, nullptr);
                continue;
            }
            const CameraRays::Sample camera = camera_.sample(x, y, sampler);
            if (options_.irradiance)
                integrator_.trace_received(camera.ray, camera.meets, camera.weight, sampler, paths);
            else
                integrator_.trace(camera.ray, camera.meets, camera.weight, sampler, paths, options_.surfaces ? &surfaces : nullptr);
        }
    }

    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(options_.width) + static_cast<std::size_t>(x);
    }

    ReferenceResult finish() {
        const std::size_t pixels = static_cast<std::size_t>(options_.width) * static_cast<std::size_t>(options_.height);
        std::vector<int> samples(pixels), sets(pixels);
        int fewest = tiles_.front().samples, fewest_sets = std::numeric_limits<int>::max();
        for (const Tile& tile : tiles_) {
            for (int y = tile.y; y < tile.y + tile.height; ++y)
                for (int x = tile.x; x < tile.x + tile.width; ++x) {
                    if (tile.set_samples > 0) film_.end_set(index(x, y), tile.set_samples);
                    samples[index(x, y)] = tile.samples;
                    sets[index(x, y)] = tile.sets + (tile.set_samples > 0 ? 1 : 0);
                }
            fewest = std::min(fewest, tile.samples);
            fewest_sets = std::min(fewest_sets, tile.sets + (tile.set_samples > 0 ? 1 : 0));
            result_.paths += static_cast<std::uint64_t>(tile.samples) * static_cast<std::uint64_t>(tile.width * tile.height);
        }
        result_.width = options_.width;
        result_.height = options_.height;
        result_.layers = film_.layers(samples, sets, scene_, eye_);
        result_.warnings = scale_light(scene_.light(), result_.layers);
        result_.estimated_error = film_.relative_mean_square_error(samples, sets);
        result_.spp = fewest;
        result_.sets = std::move(sets);
        result_.rays = rays_;
        result_.interrupted = reporter_.stopped();
        warn(fewest_sets);
        return std::move(result_);
    }

    void warn(int fewest_sets) {
        if (emitters_.empty() && options_.max_depth != 1) result_.warnings.push_back("the scene has no light: the image is black");
        if (dropped_ > 0)
            result_.warnings.push_back(std::to_string(dropped_) + " contributions of paths were no finite numbers and are left out");
        if (cut_ > 0)
            result_.warnings.push_back(
                std::to_string(cut_) +
                " paths were ended although they had lost hardly any light: the image is too dark; is some albedo 1?");
        const bool pixels = sensors_.empty();
        if (pixels && result_.spp == 0) result_.warnings.push_back("interrupted before every pixel had a path: those without are black");
        if (options_.variance && fewest_sets < 2)
            result_.warnings.push_back(pixels ? "the variance needs at least two paths per pixel; it is 0 where there are fewer"
                                              : "some sensors have a single path: nothing is known of their errors; give more --time");
    }

    ReferenceOptions options_;
    Reporter reporter_;
    Stopwatch build_watch_;
    RayScene scene_;
    Emitters emitters_;
    PathIntegrator integrator_;
    SensorReceivers sensors_;
    CameraRays camera_;
    glm::dvec3 eye_;
    FilmSums film_;
    std::vector<Tile> tiles_;
    std::atomic<std::uint64_t> rays_{0}, dropped_{0}, cut_{0};
    ReferenceResult result_;
};

}  // namespace

ReferenceResult trace_paths(const Scene& scene, const ReferenceOptions& options, const ReferenceProgress& progress) {
    return PathTracer(scene, options, progress).run();
}

}  // namespace pencil
