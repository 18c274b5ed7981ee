#include "transport/render.h"

#include <cmath>

#include "pencils/low_discrepancy.h"
#include "transport/explain.h"
#include "transport/layer_mean.h"
#include "transport/line_method.h"
#include "transport/surface_method.h"
#include "util/error.h"

namespace pencil {

namespace {

/// One render from start to end.
class Renderer {
public:
    Renderer(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs, std::shared_ptr<Device> device,
             const Progress& progress)
        : aovs_(aovs), context_(scene, options, std::move(device), progress) {}

    RenderResult run() {
        check_options();
        check_memory();
        context_.stats.explain =
            explain(context_.scene, context_.options, context_.forms, context_.kernels.features(), *context_.kernels.device());
        return context_.options.method == Method::line ? finish(render_frame(nullptr, context_.options.seed)) : render_passes();
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

    /// `bvh` only for the surface method.
    std::vector<Layer> render_frame(const DeviceBvh* bvh, std::uint64_t seed) {
        Frame frame(context_, aovs_, seed);
        const bool dark = context_.options.bounces != 0 && frame.dark();
        if (dark && context_.stats.warnings.empty()) context_.stats.warnings.push_back("the scene has no light: the image is black");
        if (!dark && context_.options.bounces != 0 && !context_.clock.stopped()) {
            frame.add_direct();
            if (bvh)
                add_surface_bounces(context_, *bvh, frame, seed);
            else
                add_line_bounces(context_, frame);
        }
        context_.stats.film_surfels = static_cast<std::uint64_t>(frame.film().surfels().count);
        return frame.take_layers();
    }

    /// Independent images until time or error tell to stop; their mean is the result.
    RenderResult render_passes() {
        const RenderOptions& options = context_.options;
        std::unique_ptr<DeviceBvh> bvh;
        context_.clock.run("hierarchy",
                           [&] { bvh = std::make_unique<DeviceBvh>(context_.kernels.device(), build_bvh(context_.flat.triangles)); });
        LayerMean mean;
        for (int pass = 0; pass < options.passes && !(pass > 0 && context_.clock.stopped()); ++pass) {
            std::vector<Layer> layers = render_frame(bvh.get(), hash64(options.seed) + static_cast<std::uint64_t>(pass));
            if (pass == 0 || !context_.clock.stopped()) mean.add(std::move(layers), 1.0);
        }
        context_.stats.estimated_error = mean.relative_mean_square_error();
        return finish(mean.take(true));
    }

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
    RenderContext context_;
};

}  // namespace

RenderResult render(const Scene& scene, const RenderOptions& options, const std::vector<std::string>& aovs, std::shared_ptr<Device> device,
                    const Progress& progress) {
    return Renderer(scene, options, aovs, std::move(device), progress).run();
}

}  // namespace pencil
