#include "transport/layer_mean.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace pencil {

namespace {

/// relMSE divides by r^2 + this * mean(r)^2, so that black pixels do not decide it.
constexpr double variance_floor = 0.01;

}  // namespace

void LayerMean::add(std::vector<Layer> layers, double weight) {
    ++count_;
    weight_ += weight;
    square_weight_ += weight * weight;
    if (count_ == 1) {
        spread_.assign(layers.front().pixels.size(), 0.0);
        mean_ = std::move(layers);
        return;
    }
    // West's update of weighted mean and variance.
    const double share = weight / weight_;
    for (std::size_t l = 0; l < mean_.size(); ++l)
        for (std::size_t i = 0; i < mean_[l].pixels.size(); ++i) {
            const double step = static_cast<double>(layers[l].pixels[i]) - static_cast<double>(mean_[l].pixels[i]);
            if (l == 0) spread_[i] += weight * (1.0 - share) * step * step;
            mean_[l].pixels[i] += static_cast<float>(share * step);
        }
}

/// Unbiased where the variance of an image is in inverse proportion to its weight.
double LayerMean::variance_of_mean(std::size_t i) const { return spread_[i] / ((count_ - 1) * weight_); }

double LayerMean::relative_mean_square_error() const {
    if (count_ < 2) return std::numeric_limits<double>::infinity();
    const std::vector<float>& pixels = mean_.front().pixels;
    const double mean = std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
    if (mean <= 0) return 0;
    double sum = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double value = pixels[i];
        sum += variance_of_mean(i) / (value * value + variance_floor * mean * mean);
    }
    return sum / static_cast<double>(pixels.size());
}

std::vector<Layer> LayerMean::take(bool with_error) {
    if (with_error && count_ >= 2) {
        Layer error{"error", 3, std::vector<float>(spread_.size())};
        for (std::size_t i = 0; i < spread_.size(); ++i) error.pixels[i] = static_cast<float>(std::sqrt(variance_of_mean(i)));
        mean_.push_back(std::move(error));
    }
    return std::move(mean_);
}

}  // namespace pencil
