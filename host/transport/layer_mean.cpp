#include "transport/layer_mean.h"

#include <algorithm>
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
    weight2_ += weight * weight;
    weight3_ += weight * weight * weight;
    if (count_ == 1) {
        first_ = layers.front().pixels;
        value_.assign(first_.size(), 0.0);
        square_.assign(first_.size(), 0.0);
        mean_ = std::move(layers);
        return;
    }
    for (std::size_t i = 0; i < first_.size(); ++i) {
        const double value = static_cast<double>(layers.front().pixels[i]) - static_cast<double>(first_[i]);
        value_[i] += weight * weight * value;
        square_[i] += weight * weight * value * value;
    }
    const double share = weight / weight_;
    for (std::size_t l = 0; l < layers.size(); ++l)
        for (std::size_t i = 0; i < mean_[l].pixels.size(); ++i)
            mean_[l].pixels[i] +=
                static_cast<float>(share * (static_cast<double>(layers[l].pixels[i]) - static_cast<double>(mean_[l].pixels[i])));
}

/// sum(w^2 (x - mean)^2) / sum(w)^2, right whatever the variances of the images are (White 1980), times what makes it unbiased where they
/// are equal.
double LayerMean::variance_of_mean(std::size_t i) const {
    const double mean = static_cast<double>(mean_.front().pixels[i]) - static_cast<double>(first_[i]);
    const double sum = std::max(square_[i] - 2.0 * mean * value_[i] + mean * mean * weight2_, 0.0);
    const double left = weight2_ - 2.0 * weight3_ / weight_ + weight2_ * weight2_ / (weight_ * weight_);
    return sum / (weight_ * weight_) * (weight2_ / left);
}

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
        Layer error{"error", 3, std::vector<float>(first_.size())};
        for (std::size_t i = 0; i < first_.size(); ++i) error.pixels[i] = static_cast<float>(std::sqrt(variance_of_mean(i)));
        mean_.push_back(std::move(error));
    }
    return std::move(mean_);
}

}  // namespace pencil
