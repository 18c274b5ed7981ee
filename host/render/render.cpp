#include "render/render.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"
#include "line/placement/candidate_source.h"
#include "render/explain.h"
#include "film/layer_mean.h"
#include "line/line_method.h"
#include "surface/surface_method.h"
#include "util/error.h"
#include "util/stopwatch.h"

namespace pencil {

namespace {

/// A target that is never met ends here.
constexpr int most_passes = 1 << 14;

/// One render from start to end.
class Renderer {
public:
    Renderer(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs, std::shared_ptr<Device> device,
             const Progress& progress)
        : aovs_(aovs), built_before_(device->build_seconds()), context_(scene, options, std::move(device), progress) {}

    RenderResult run() {
        check_options();
        check_memory();
        context_.stats.explain = explain(context_.scene, context_.options, context_.forms, context_.kernels.features(), map_sentence(),
                                         *context_.kernels.device());
        return context_.options.method == Method::line ? render_line() : render_passes();
    }

private:
    /// Limits of the kernels' 32-bit indices and layouts, for callers that bypass the command line.
    void check_options() const {
        const RenderOptions& options = context_.options;
        if (options.map < 8 || options.map % 8 != 0)
            throw UsageError("the map size must be a multiple of 8, not " + std::to_string(options.map));
        if (options.film_samples < 1 || options.film_samples > 64)
            throw UsageError("film samples must be 1 to 64, not " + std::to_string(options.film_samples));
        if (options.pencils < 1 || options.decay <= 0 || options.decay > 1)
            throw UsageError("at least one pencil and a decay in (0, 1] are needed");
        if (options.weights == Weights::analytic && !fills_box_evenly(options.placement))
            throw UsageError(
                "--weights analytic holds for centres spread evenly, --placement random or lds; take --weights dpdf or voronoi");
    }

    void check_memory() const {
        const Camera& camera = context_.flat.camera;
        const double pixels = static_cast<double>(camera.width) * camera.height;
        const double bytes = film_bytes(pixels, context_.options.film_samples);
        const double available = static_cast<double>(context_.kernels.device()->info().global_memory);
        if (bytes > available)
            throw MemoryError("a film of " + std::to_string(camera.width) + "x" + std::to_string(camera.height) + " pixels needs about " +
                              std::to_string(static_cast<long long>(bytes / (1 << 20))) + " MiB of device memory, " +
                              std::to_string(static_cast<long long>(available / (1 << 20))) + " MiB exist; use a smaller --resolution");
    }

    /// How geometry maps are made, empty if none are.
    std::string map_sentence() const {
        if (context_.batches.empty()) return "";
        const int units = static_cast<int>(context_.kernels.device()->info().compute_units);
        return explain_paths(context_.device_scene.triangle_count, context_.batches, units, context_.prepared);
    }

    RenderResult render_line() {
        const RenderOptions& options = context_.options;
        Frame frame(context_, aovs_, options.light_samples, light_map_size(options.map), {options.seed});
        if (add_direct(frame)) add_line_bounces(context_, frame);
        return finish(frame.take_layers());
    }

    /// False if nothing more can be added: no light, no reflections wanted, or interrupted.
    bool add_direct(Frame& frame) {
        RenderStats& stats = context_.stats;
        stats.film_surfels = static_cast<std::uint64_t>(frame.film().surfels().count);
        if (context_.options.bounces == 0) return false;
        if (frame.dark() && stats.warnings.empty()) stats.warnings.push_back("the scene has no light: the image is black");
        if (frame.dark() || context_.clock.stopped()) return false;
        frame.add_direct();
        return true;
    }

    /// Layers of light: those of surfaces hardly gain from further passes.
    static std::vector<std::string> light_layers(const std::vector<std::string>& aovs) {
        std::vector<std::string> layers;
        for (const char* name : {"emission", "direct", "bounces"})
            if (std::find(aovs.begin(), aovs.end(), name) != aovs.end()) layers.push_back(name);
        return layers;
    }

    /// Images until time or error tell to stop; their mean is the result.
    RenderResult render_passes() {
        LayerMean mean;
        SurfaceMethod method(context_);
        double spent = seconds();
        for (int index = 0;; ++index) {
            const SurfacePass pass = surface_pass(index, context_.options, context_.flat.camera, emitters());
            const auto sequence = static_cast<std::uint64_t>(index) % LayerMean::sequences;
            const Turn turn{hash64(hash64(context_.options.seed) - sequence - 1), static_cast<std::uint64_t>(index) / LayerMean::sequences};
            bool lit = false;
            try {
                Frame frame(context_, index == 0 ? aovs_ : light_layers(aovs_), pass.light_samples, 0, turn);
                lit = add_direct(frame);
                if (lit) method.add_bounces(pass, turn, frame);
                if (index > 0 && context_.clock.stopped()) break;  // half a pass is worth nothing beside whole ones
                mean.add(frame.take_layers(), pass.weight, pass.generation);
            } catch (const MemoryError& error) {
                if (mean.count() == 0) throw;
                context_.stats.warnings.push_back("stopped after " + std::to_string(mean.count()) + " passes: " + error.what());
                break;
            }
            const double now = seconds();
            if (!lit || context_.clock.stopped() || enough(mean, index, (now - spent) / pass.work)) break;
            spent = now;
        }
        context_.stats.passes = mean.count();
        context_.stats.estimated_error = mean.relative_mean_square_error();
        return finish(mean.take(true));
    }

    /// Shapes whose light is sampled.
    int emitters() const {
        int count = 0;
        for (std::size_t i = 0; i < context_.forms.size(); ++i)
            count += context_.scene.shapes[i].emits && context_.forms[i] == LightForm::samples ? 1 : 0;
        return count;
    }

    /// True if the next pass is not needed or would not end in time; `pace`: seconds per unit of work.
    bool enough(const LayerMean& mean, int index, double pace) {
        const RenderOptions& options = context_.options;
        if (options.seconds > 0) {
            context_.clock.set_fraction(std::min(seconds() / options.seconds, 1.0));
            return seconds() + pace * surface_pass(index + 1, options, context_.flat.camera, emitters()).work > options.seconds;
        }
        const double error = mean.relative_mean_square_error();
        if (mean.count() >= 2) context_.clock.set_fraction(std::min(options.target_error / error, 1.0));
        if (mean.count() >= 2 && !std::isfinite(error)) {
            context_.stats.warnings.push_back("the image holds values that are not finite: stopped, the error is not known");
            return true;
        }
        return error <= options.target_error || index + 1 >= most_passes;
    }

    /// Since the start, but for building kernels: that is the driver's time, and none once its cache is warm.
    double seconds() const { return watch_.seconds() - (context_.kernels.device()->build_seconds() - built_before_); }

    RenderResult finish(std::vector<Layer> layers) {
        RenderResult result;
        result.layers = std::move(layers);
        result.width = context_.flat.camera.width;
        result.height = context_.flat.camera.height;
        result.interrupted = context_.clock.stopped();
        RenderStats& stats = context_.stats;
        stats.stages = context_.clock.stages();
        stats.device_peak_bytes = context_.kernels.device()->peak_allocated();
        stats.triangles = context_.flat.triangles.size();
        result.stats = std::move(stats);
        return result;
    }

    std::vector<std::string> aovs_;
    Stopwatch watch_;
    double built_before_;  // seconds of kernel builds for earlier renders on the device
    RenderContext context_;
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs, std::shared_ptr<Device> device,
                    const Progress& progress) {
    return Renderer(scene, options, aovs, std::move(device), progress).run();
}

}  // namespace pencil
