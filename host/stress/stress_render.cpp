#include "stress/stress_render.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pencil {

RenderResult render(const Scene& scene, const RenderOptions& options, const StressRun& run) {
    RenderResult result = render(scene, options, run.device, run.progress);
    if (result.interrupted) throw StressStopped();
    return result;
}

ReferenceResult trace_paths(const Scene& scene, const ReferenceOptions& options, const StressRun& run) {
    ReferenceResult result = trace_paths(scene, options, run.progress);
    if (result.interrupted) throw StressStopped();
    return result;
}

RenderOptions stress_options(MethodName method) {
    RenderOptions options;
    options.method = method;
    options.aovs = {};
    options.film_samples = 4;
    options.target_error = 1e6;  // as few passes as may be
    if (method != MethodName::surface) {
        options.pencils = 32;
        options.map = 32;
    } else {
        options.pencils = 200;
    }
    return options;
}

double mean_of(const std::vector<Layer>& layers) {
    const std::vector<float>& v = layers.front().pixels;
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

double difference_of(const std::vector<Layer>& image, const std::vector<Layer>& other, double factor) {
    const std::vector<float>&a = image.front().pixels, &b = other.front().pixels;
    const double mean = factor * mean_of(other);
    double sum = a.size() == b.size() ? 0 : HUGE_VAL;
    for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) {
        const double d = (static_cast<double>(a[i]) - factor * static_cast<double>(b[i])) / mean;
        sum += d * d / static_cast<double>(a.size());
    }
    return std::sqrt(sum);
}

double non_finite_of(const std::vector<Layer>& layers) {
    const std::vector<float>& v = layers.front().pixels;
    return static_cast<double>(std::count_if(v.begin(), v.end(), [](float x) { return !std::isfinite(x); }));
}

double error_of(const std::vector<Layer>& layers, double truth) {
    double worst = 0;
    for (const float v : layers.front().pixels) {
        const double d = std::abs(static_cast<double>(v) - truth);
        worst = std::max(worst, std::isfinite(d) ? d / std::abs(truth) : HUGE_VAL);
    }
    return worst;
}

}  // namespace pencil
