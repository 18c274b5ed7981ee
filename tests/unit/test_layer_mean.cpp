// Means of independent images and their error, against samples of known variance.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/random.h"
#include "transport/layer_mean.h"

namespace {

using namespace pencil;

/// A beauty of `size` values 2 + noise of standard deviation `sigma`, uniform.
std::vector<Layer> noisy(ref::Random& random, std::size_t size, double sigma) {
    Layer beauty{"", 3, std::vector<float>(size)};
    for (float& value : beauty.pixels) value = static_cast<float>(2.0 + sigma * std::sqrt(12.0) * (random.uniform() - 0.5));
    return {beauty};
}

TEST(LayerMean, OneImageIsItselfWithUnknownError) {
    LayerMean mean;
    mean.add({Layer{"", 3, {1, 2, 3}}}, 1.0);
    EXPECT_TRUE(std::isinf(mean.relative_mean_square_error()));
    const std::vector<Layer> layers = mean.take(true);
    ASSERT_EQ(layers.size(), 1U);
    EXPECT_EQ(layers[0].pixels, (std::vector<float>{1, 2, 3}));
}

TEST(LayerMean, WeightsCount) {
    LayerMean mean;
    mean.add({Layer{"", 3, {0, 0, 0}}, Layer{"direct", 3, {4, 4, 4}}}, 1.0);
    mean.add({Layer{"", 3, {3, 6, 9}}, Layer{"direct", 3, {1, 1, 1}}}, 2.0);
    const std::vector<Layer> layers = mean.take(true);
    ASSERT_EQ(layers.size(), 3U);
    EXPECT_FLOAT_EQ(layers[0].pixels[1], 4.0F);
    EXPECT_FLOAT_EQ(layers[1].pixels[0], 2.0F);
    EXPECT_EQ(layers[2].name, "error");
    // sum w^2 (x - m)^2 = 8, over (sum w)^2 = 9; times sum w^2 = 5 over 5 - 2 * 9 / 3 + 25 / 9
    EXPECT_FLOAT_EQ(layers[2].pixels[0], std::sqrt(8.0F / 9.0F * 5.0F / (16.0F / 9.0F)));
}

/// Estimated over true relMSE of a mean of images with weights 1, 2, 1, 2 ... and variances 0.04 / weight^power.
double estimate_over_truth(int images, double power) {
    ref::Random random(3);
    LayerMean mean;
    double weights = 0, variance = 0;
    for (int k = 0; k < images; ++k) {
        const double weight = k % 2 == 0 ? 1.0 : 2.0, sigma = 0.2 / std::sqrt(std::pow(weight, power));
        mean.add(noisy(random, 30000, sigma), weight);
        weights += weight;
        variance += weight * weight * sigma * sigma;
    }
    return mean.relative_mean_square_error() / (variance / (weights * weights) / (4.0 + 0.01 * 4.0));
}

TEST(LayerMean, EstimatesTheErrorOfTheMean) {
    for (const int images : {2, 3, 10}) EXPECT_NEAR(estimate_over_truth(images, 0.0), 1.0, 0.05) << images << " images";
    for (const double power : {-1.0, 1.0}) EXPECT_NEAR(estimate_over_truth(40, power), 1.0, 0.05) << "variance by weight^" << -power;
}

TEST(LayerMean, BlackImagesHaveNoError) {
    LayerMean mean;
    for (int k = 0; k < 2; ++k) mean.add({Layer{"", 3, {0, 0, 0}}}, 1.0);
    EXPECT_EQ(mean.relative_mean_square_error(), 0.0);
}

}  // namespace
