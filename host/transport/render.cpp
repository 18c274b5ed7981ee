#include "transport/render.h"

#include <algorithm>
#include <cmath>

#include "pencils/light_samples.h"
#include "transport/bounce_series.h"
#include "transport/emit_surfels.h"
#include "transport/explain.h"
#include "transport/film.h"
#include "transport/film_layers.h"
#include "transport/light_surfels.h"
#include "transport/pencil_solver.h"
#include "transport/project_pencils.h"
#include "transport/rasterize_octahedral.h"
#include "transport/sum_radiance.h"
#include "util/error.h"

namespace pencil {

namespace {

/// Orders of bounces after which the series is closed by its tail whatever the tolerance.
constexpr int kMostBounces = 512;
/// Tiles of light samples are finer than pencil maps, because shadow edges are seen directly, but not finer than this.
constexpr int kLightMapFactor = 4;
constexpr int kLargestLightMap = 256;

int light_map_size(int map) { return std::max(map, std::min(kLightMapFactor * map, kLargestLightMap)); }

/// One render from start to end; the members are its state, the methods its stages in order.
class Renderer {
public:
    Renderer(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs, std::shared_ptr<Device> device,
             const Progress& progress)
        : scene_(scene),
          options_(options),
          forms_(choose_light_forms(scene, options.initial == Initial::direct, options.initial == Initial::emission)),
          flat_(flatten(scene, forms_, options.width, options.height)),
          kernels_(device, detect_features(flat_, options.weights == Weights::thesis, options.film_samples)),
          clock_(device, progress),
          device_scene_(device, flat_),
          layers_(aovs) {}

    RenderResult run() {
        check_options();
        check_memory();
        explain_decisions();
        clock_.run("film geometry",
                   [&] { film_ = std::make_unique<Film>(kernels_, device_scene_, flat_.camera, scene_.sensor.filter, options_.seed); });
        clock_.run("light sample maps", [&] { make_lights(); });
        clock_.run("surface layers", [&] { layers_.add_surfaces(kernels_, device_scene_, flat_, *film_); });
        const bool dark = options_.bounces != 0 && lights_.maps.count == 0 && !maps_emit_;
        if (dark) result_.stats.warnings.push_back("the scene has no light: the image is black");
        if (!dark && options_.bounces != 0 && !clock_.stopped()) {
            light_film();
            bounce();
        }
        return finish();
    }

private:
    /// Limits of the kernels' 32-bit indices and layouts, for callers that bypass the command line.
    void check_options() {
        if (options_.map < 8 || options_.map % 8 != 0)
            throw UsageError("the map size must be a multiple of 8, not " + std::to_string(options_.map));
        if (options_.film_samples < 1 || options_.film_samples > 64)
            throw UsageError("film samples must be 1 to 64, not " + std::to_string(options_.film_samples));
        if (options_.pencils < 1 || options_.decay <= 0 || options_.decay > 1)
            throw UsageError("at least one pencil and a decay in (0, 1] are needed");
    }

    void check_memory() {
        const double pixels = static_cast<double>(flat_.camera.width) * flat_.camera.height;
        const double bytes = film_bytes(pixels, options_.film_samples);
        const double available = static_cast<double>(kernels_.device()->info().global_memory);
        if (bytes > available)
            throw MemoryError("a film of " + std::to_string(flat_.camera.width) + "x" + std::to_string(flat_.camera.height) +
                              " pixels needs about " + std::to_string(static_cast<long long>(bytes / (1 << 20))) +
                              " MiB of device memory, " + std::to_string(static_cast<long long>(available / (1 << 20))) +
                              " MiB exist; use a smaller --resolution");
    }

    void explain_decisions() { result_.stats.explain = explain(scene_, options_, forms_, kernels_.features(), *kernels_.device()); }

    void explain_placement(const FreeSpace& free_space) {
        std::string rooms;
        for (int shape : free_space.rooms()) rooms += (rooms.empty() ? "" : ", ") + scene_.shapes[static_cast<std::size_t>(shape)].id;
        result_.stats.explain.push_back("placement: rejected " + std::to_string(free_space.in_solids()) + " centres inside solids and " +
                                        std::to_string(free_space.unreached()) + " that see no surface which film, lights or others see" +
                                        (rooms.empty() ? std::string() : "; rooms, because the camera or a light is inside: " + rooms));
    }

    void make_lights() {
        if (options_.bounces == 0) return;  // emission only
        const std::vector<LightSample> samples = sample_lights(scene_, flat_, forms_, options_.light_samples, options_.seed);
        for (std::size_t i = 0; i < forms_.size(); ++i) maps_emit_ = maps_emit_ || (scene_.shapes[i].emits && forms_[i] == LightForm::maps);
        if (samples.empty()) return;
        lights_ = LightSet(kernels_.device(), samples, light_map_size(options_.map));
        rasterize_octahedral(kernels_, device_scene_, lights_.maps, 0, lights_.maps.count);
    }

    /// Direct light of the light samples; emitters carried by the maps add theirs as the first projection.
    void light_film() {
        outgoing_ = surfel_rgb(kernels_.device(), film_->surfels().capacity, "film radiance");
        visible_ = Buffer<int>(kernels_.device(), static_cast<std::size_t>(film_->surfels().capacity), "visible pencils");
        if (lights_.maps.count == 0) return;
        clock_.run("direct light",
                   [&] { light_surfels(kernels_, device_scene_, film_->surfels(), lights_, outgoing_, "direct light to film"); });
        if (!maps_emit_) finish_bounce(1, 0, 0);
    }

    /// thesis alg. 6.4, or eq. (6.1) for one fixed set. The maps of step k hold the radiance of bounce order k and make layer k + 1.
    void bounce() {
        int order = maps_emit_ ? 0 : 1;
        if (!wanted(order + 1) || clock_.stopped()) return;
        std::unique_ptr<FreeSpace> free_space;
        clock_.run("pencil maps", [&] {
            free_space = std::make_unique<FreeSpace>(kernels_, device_scene_, flat_, film_->surfels(),
                                                     lights_.maps.count > 0 ? &lights_.maps : nullptr, options_.map);
        });
        PencilSolver solver(kernels_, device_scene_, *free_space, lights_, options_, clock_);
        PencilSet set = solver.create(0);
        solver.fill(set, nullptr, maps_emit_, !maps_emit_, true);
        for (int index = 0;; ++index, ++order) {
            series_.add(sum_radiance(kernels_, set));
            const double seconds = clock_.run("projection-scatter", [&] {
                project_pencils(kernels_, device_scene_, film_->surfels(), set, outgoing_, visible_, "projection-scatter");
            });
            if (index == 0) count_blind();
            finish_bounce(order + 1, set.maps->count, seconds);
            clock_.set_fraction(progress());
            if (clock_.stopped() || !wanted(order + 2) || converged(index)) break;
            // Emitters of the other form join the maps after one bounce: from there on both carry order 1.
            set = next_set(solver, set, index + 1, order == 0 && lights_.maps.count > 0);
        }
        explain_placement(*free_space);
    }

    bool wanted(int reflections) const { return options_.bounces < 0 || reflections <= options_.bounces; }

    /// The set that carries the next bounce order: new pencils, or the same ones with new radiance.
    PencilSet next_set(PencilSolver& solver, const PencilSet& set, int index, bool direct) {
        const bool fixed = options_.iterate == Iterate::fixed;
        PencilSet next = fixed ? PencilSet(kernels_.device(), set.maps) : solver.create(index);
        if (fixed)
            next.radiance.copy_from(set.radiance, 0, 0, set.radiance.size());  // the quadrature weights stay, the radiance is overwritten
        solver.fill(next, &set, false, direct, !fixed);
        return next;
    }

    /// Adds what `outgoing_` holds as the reflection of this order to the layers, and clears it.
    void finish_bounce(int order, int pencils, double projection_seconds) {
        clock_.run("resolve film", [&] {
            std::vector<float> pixels = film_->resolve(kernels_, outgoing_);
            BounceReport report;
            report.order = order;
            report.pencils = pencils;
            report.mean = mean_rgb(pixels);
            report.projection_seconds = projection_seconds;
            result_.stats.bounces.push_back(report);
            layers_.add_bounce(order, std::move(pixels));
        });
        outgoing_.fill_zero();
    }

    /// Stops the series by tolerance; warns and stops a series that does not decrease.
    bool converged(int steps) {
        if (series_.last_share() < options_.tolerance) return true;
        if (steps < kMostBounces) return false;
        result_.stats.warnings.push_back("bounces do not decrease (albedo near 1 in a closed scene): stopped after " +
                                         std::to_string(kMostBounces) + ", not converged");
        return true;
    }

    /// Fraction of the work done, from how far the last bounce has fallen towards the tolerance on a logarithmic scale.
    double progress() const {
        if (options_.bounces > 0) return static_cast<double>(result_.stats.bounces.size()) / options_.bounces;
        const double share = std::max(series_.last_share(), options_.tolerance);
        return std::clamp(std::log(share) / std::log(std::min(options_.tolerance, 0.5)), 0.0, 1.0);
    }

    void count_blind() {
        const std::vector<int> visible = visible_.read(0, static_cast<std::size_t>(film_->surfels().count));
        result_.stats.blind_surfels = static_cast<std::uint64_t>(std::count(visible.begin(), visible.end(), 0));
        if (result_.stats.blind_surfels > visible.size() / 100)
            result_.stats.warnings.push_back(std::to_string(result_.stats.blind_surfels) + " of " + std::to_string(visible.size()) +
                                             " film surfels are seen by no pencil and get no indirect light; use more --pencils");
    }

    RenderResult finish() {
        if (!clock_.stopped() && options_.bounces < 0 && series_.steps() > 1) {
            result_.stats.tail_closed = true;
            result_.stats.residual = layers_.close_series(series_.tail_factor());
        }
        result_.layers = layers_.take(film_->width(), film_->height());
        result_.width = film_->width();
        result_.height = film_->height();
        result_.interrupted = clock_.stopped();
        RenderStats& stats = result_.stats;
        stats.stages = clock_.stages();
        stats.device_peak_bytes = kernels_.device()->peak_allocated();
        stats.triangles = flat_.triangles.size();
        stats.film_surfels = static_cast<std::uint64_t>(film_->surfels().count);
        return std::move(result_);
    }

    const Scene& scene_;
    RenderOptions options_;
    std::vector<LightForm> forms_;
    FlatScene flat_;
    Kernels kernels_;
    StageClock clock_;
    DeviceScene device_scene_;
    FilmLayers layers_;
    std::unique_ptr<Film> film_;
    LightSet lights_;
    bool maps_emit_ = false;
    Buffer<float> outgoing_;
    Buffer<int> visible_;
    BounceSeries series_;
    RenderResult result_;
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs, std::shared_ptr<Device> device,
                    const Progress& progress) {
    return Renderer(scene, options, aovs, std::move(device), progress).run();
}

}  // namespace pencil
