// Weighted mean of independent images of the same scene, and what their spread says about its error.
#pragma once

#include <vector>

#include "transport/render.h"

namespace pencil {

class LayerMean {
public:
    /// Adds an image that is worth `weight` (in proportion to the work in it). All images have the same layers.
    void add(std::vector<Layer> layers, double weight);

    int count() const { return count_; }

    /// Estimated relative mean square error of the mean beauty, relMSE of an image without noise: the variance of the mean over its square.
    /// Needs two images; infinite before.
    double relative_mean_square_error() const;

    /// The layers of the mean; with two images or more a layer "error" follows: the estimated standard error of every beauty value.
    std::vector<Layer> take(bool with_error);

private:
    double variance_of_mean(std::size_t i) const;

    int count_ = 0;
    double weight_ = 0, square_weight_ = 0;
    std::vector<Layer> mean_;
    std::vector<double> spread_;  // sum of weight * (value - mean)^2 of the beauty
};

}  // namespace pencil
