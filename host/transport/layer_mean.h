// Weighted mean of independent images of the same scene, and what their spread says about its error.
#pragma once

#include <vector>

#include "transport/render.h"

namespace pencil {

class LayerMean {
public:
    /// Adds an image with its weight in the mean. Later images have the layers of the first, or the first of them: the others stay as they
    /// are.
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
    double weight_ = 0, weight2_ = 0, weight3_ = 0;  // sums of the weights' powers
    std::vector<Layer> mean_;
    std::vector<double> value_, square_;  // sums of weight^2 * value and weight^2 * value^2 of the beauty, values less the first image's
    std::vector<float> first_;            // beauty of the first image
};

}  // namespace pencil
