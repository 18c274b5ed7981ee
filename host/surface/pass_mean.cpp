#include "surface/pass_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pencil {

namespace {

/// How many times the square spread of so many passes counts: they share a blur that it does not show, the more of it the fewer they are,
/// since the first are the coarsest, and the spread of few is itself hardly known (docs/accuracy.md).
double caution(int passes) { return 1 + 8.0 / (static_cast<double>(passes) * passes); }

double joined(double spread, const CertifiedError& certified) {
    const double error = join_errors(spread, certified);
    return std::isnan(error) ? std::numeric_limits<double>::infinity() : error;
}

}  // namespace

PassMean::PassMean(RenderContext& context) : context_(context), check_(context) {}

void PassMean::add(std::vector<Layer> layers, const std::vector<float>& emission, const SurfacePass& pass) {
    const std::vector<float>& beauty = layers.front().pixels;
    of_pixels_.add(std::accumulate(beauty.begin(), beauty.end(), 0.0) / static_cast<double>(beauty.size()), pass.weight, pass.world_set);
    mean_.add(std::move(layers), pass.weight, pass.generation, spreads_outliers() ? pass.world_set : -1);
    check_.add_emission(emission, pass.weight);
}

/// The mean of the passes as it is shown, in `copy` if it differs: rare light along lobes is spread over where it may come to.
const LayerMean& PassMean::shown(LayerMean& copy) const {
    if (!spreads_outliers() || mean_.count() == 0) return mean_;
    copy = mean_;
    copy.spread_outliers(context_.flat.camera.width);
    return copy;
}

bool PassMean::spreads_outliers() const { return context_.kernels.features().lobes && context_.scene.sensor_points.empty(); }

/// Relative; passes of one world set share where its pencils lie.
double PassMean::mean_error_of_pixels() const {
    const double error =
        std::max(student(of_pixels_.count()) * std::sqrt(of_pixels_.square_error()), std::sqrt(of_pixels_.square_error_of_groups()));
    return of_pixels_.mean() > 0 ? error / of_pixels_.mean() : 0;
}

double PassMean::noise_of_mean() const {
    const double mean = of_pixels_.mean();
    return of_pixels_.count() > 1 && mean > 0 ? of_pixels_.square_error() / (mean * mean) * of_pixels_.count() : 0;
}

PassErrors PassMean::errors() const {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    if (mean_.count() == 0) return {infinite, infinite, infinite, {}};
    LayerMean copy;
    const LayerMean& mean = shown(copy);
    const CertifiedError certified = check_.certify(mean.beauty(), mean.usual_values());
    const double mean_error = mean_error_of_pixels();
    if (!context_.stats.bounce_solve.has_sum) return {infinite, infinite, mean_error, certified};
    const double spread = caution(mean.count()) * mean.relative_mean_square_error();
    CertifiedError at_least = certified;
    at_least.relmse -= 2 * certified.standard_error;
    return {joined(spread, certified), joined(spread, at_least), mean_error, certified};
}

std::vector<Layer> PassMean::snapshot() const {
    LayerMean copy;
    return LayerMean(shown(copy)).take();
}

std::vector<Layer> PassMean::take() {
    if (spreads_outliers()) mean_.spread_outliers(context_.flat.camera.width);
    return mean_.take();
}

void PassMean::transfer(Archive& archive) {
    const std::size_t pixels = static_cast<std::size_t>(context_.options.width) * static_cast<std::size_t>(context_.options.height);
    mean_.transfer(archive, pixels);
    of_pixels_.transfer(archive);
    check_.transfer(archive, pixels);
}

}  // namespace pencil
