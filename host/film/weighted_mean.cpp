#include "film/weighted_mean.h"

#include <algorithm>
#include <limits>

namespace pencil {

namespace {

/// Fewer means of groups agree or differ by chance.
constexpr std::size_t least_groups = 4;

}  // namespace

void WeightedMean::add(double value, double weight, int group) {
    if (count_++ == 0) first_ = value;
    if (groups_.empty() || groups_.back().group != group) groups_.push_back({group, 0, 0});
    const double step = value - first_;
    all_.add(step, weight);
    groups_.back().add(step, weight);
    square_weight_ += weight * weight;
    square_step_ += weight * weight * step;
    square_square_ += weight * weight * step * step;
}

/// sum(W^2 (M - mean)^2) / sum(W)^2 over values M of weight W, times n / (n - 1).
double WeightedMean::square_error() const {
    if (count_ < 2) return std::numeric_limits<double>::infinity();
    const double step = all_.mean(), sum = square_square_ - 2 * step * square_step_ + step * step * square_weight_;
    return std::max(sum, 0.0) * count_ / (count_ - 1.0) / (all_.weight * all_.weight);
}

/// The same over groups, times sum(W) / (sum(W) - W) of each, which is right where their variances are as 1 / W.
double WeightedMean::square_error_of_groups() const {
    if (groups_.size() < least_groups) return 0;
    double sum = 0;
    for (const Sum& g : groups_) {
        const double step = g.value - g.weight * all_.mean();
        sum += step * step / (1 - g.weight / all_.weight);
    }
    return sum / (all_.weight * all_.weight);
}

}  // namespace pencil
