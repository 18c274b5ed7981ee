#include "reference/filter_sampler.h"

#include <algorithm>
#include <cmath>

#include "scene/filter_value.h"

namespace pencil {
namespace {

constexpr int cells_per_pixel = 64;  // even, so that pixel borders are cell borders
constexpr double cell = 1.0 / cells_per_pixel;

/// Gauss and Legendre, three points: exact for the piecewise cubic filters where no knot lies inside.
template <typename Function>
double integrate(double a, double b, Function f) {
    const double middle = 0.5 * (a + b), half = 0.5 * (b - a), node = half * std::sqrt(0.6);
    return half * (5 * f(middle - node) + 8 * f(middle) + 5 * f(middle + node)) / 9;
}

}  // namespace

FilterSampler::FilterSampler(const ReconstructionFilter& filter) : filter_(filter) {
    const int half = static_cast<int>(std::ceil(filter.radius * cells_per_pixel));
    radius_ = half * cell;
    magnitude_.push_back(0);
    integral_.push_back(0);
    for (int i = -half; i < half; ++i) {
        const double a = std::max(i * cell, -filter.radius), b = std::min((i + 1) * cell, filter.radius);
        const double magnitude = integrate(a, b, [&](double x) { return std::abs(filter_value(filter, x)); });
        density_.push_back(magnitude / cell);
        magnitude_.push_back(magnitude_.back() + magnitude);
        integral_.push_back(integral_.back() + integrate(a, b, [&](double x) { return filter_value(filter, x); }));
    }
}

double FilterSampler::at(const std::vector<double>& running, double x) const {
    const auto index = static_cast<std::ptrdiff_t>(std::lround((x + radius_) * cells_per_pixel));
    return running[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, static_cast<std::ptrdiff_t>(running.size()) - 1))];
}

FilterSampler::Sample FilterSampler::sample(double u, double low, double high) const {
    const double first = at(magnitude_, low), last = at(magnitude_, high);
    const double target = first + u * (last - first);
    const auto above = std::upper_bound(magnitude_.begin() + 1, magnitude_.end() - 1, target);
    const auto i = static_cast<std::size_t>(above - magnitude_.begin()) - 1;
    const double inside = (target - magnitude_[i]) / (magnitude_[i + 1] - magnitude_[i]);
    const double offset = (static_cast<double>(i) + std::clamp(inside, 0.0, 1.0)) * cell - radius_;
    const double scale = (last - first) / (at(integral_, high) - at(integral_, low));
    return {offset, static_cast<float>(filter_value(filter_, offset) / density_[i] * scale)};
}

}  // namespace pencil
