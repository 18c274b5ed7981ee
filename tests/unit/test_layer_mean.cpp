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
    // sum w (x - m)^2 / ((n - 1) sum w) = (1 * 4 + 2 * 1) / 3
    EXPECT_FLOAT_EQ(layers[2].pixels[0], std::sqrt(2.0F));
}

TEST(LayerMean, EstimatesTheErrorOfTheMean) {
    ref::Random random(3);
    const std::size_t size = 30000;
    for (const int images : {2, 3, 10}) {
        LayerMean mean;
        double weights = 0;
        for (int k = 0; k < images; ++k) {
            const double weight = k % 2 == 0 ? 1.0 : 2.0;  // twice the work, half the variance
            mean.add(noisy(random, size, 0.2 / std::sqrt(weight)), weight);
            weights += weight;
        }
        const double truth = 0.04 / weights / (4.0 + 0.01 * 4.0);
        EXPECT_NEAR(mean.relative_mean_square_error() / truth, 1.0, 0.05) << images << " images";
    }
}

TEST(LayerMean, BlackImagesHaveNoError) {
    LayerMean mean;
    for (int k = 0; k < 2; ++k) mean.add({Layer{"", 3, {0, 0, 0}}}, 1.0);
    EXPECT_EQ(mean.relative_mean_square_error(), 0.0);
}

}  // namespace
