// Means of independent images and their error, against samples of known variance.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "film/layer_mean.h"
#include "reference/random.h"

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
    mean.add({Layer{"", 3, {1, 2, 3}}}, 1.0, 0);
    EXPECT_TRUE(std::isinf(mean.relative_mean_square_error()));
    const std::vector<Layer> layers = mean.take();
    ASSERT_EQ(layers.size(), 1U);
    EXPECT_EQ(layers[0].pixels, (std::vector<float>{1, 2, 3}));
}

TEST(LayerMean, WeightsCount) {
    LayerMean mean;
    mean.add({Layer{"", 3, {0, 0, 0}}, Layer{"direct", 3, {4, 4, 4}}}, 1.0, 0);
    mean.add({Layer{"", 3, {3, 6, 9}}, Layer{"direct", 3, {1, 1, 1}}}, 2.0, 0);
    const std::vector<Layer> layers = mean.take();
    ASSERT_EQ(layers.size(), 3U);
    EXPECT_FLOAT_EQ(layers[0].pixels[1], 4.0F);
    EXPECT_FLOAT_EQ(layers[1].pixels[0], 2.0F);
    EXPECT_EQ(layers[2].name, "error");
    // sum w^2 (x - m)^2 / (1 - w / sum w) = 1 * 4 / (2 / 3) + 4 * 1 / (1 / 3), over (sum w)^2 = 9
    EXPECT_FLOAT_EQ(layers[2].pixels[0], std::sqrt(18.0F / 9.0F));
}

/// Estimated over true relMSE of a mean of images with weights 1, `second`, 1, `second` ... and variances 0.04 / weight^power.
double estimate_over_truth(int images, double second, double power) {
    ref::Random random(3);
    LayerMean mean;
    double weights = 0, variance = 0;
    for (int k = 0; k < images; ++k) {
        const double weight = k % 2 == 0 ? 1.0 : second, sigma = 0.2 / std::sqrt(std::pow(weight, power));
        mean.add(noisy(random, 30000, sigma), weight, 0);
        weights += weight;
        variance += weight * weight * sigma * sigma;
    }
    return mean.relative_mean_square_error() / (variance / (weights * weights) / (4.0 + 0.01 * 4.0));
}

TEST(LayerMean, EstimatesTheErrorOfTheMean) {
    for (const int images : {2, 3, 4, 5, 10, 40}) EXPECT_NEAR(estimate_over_truth(images, 1.0, 0.0), 1.0, 0.05) << images << " images";
    EXPECT_NEAR(estimate_over_truth(2, 2.0, 1.0), 1.0, 0.05);
    for (const double power : {-1.0, 0.0, 1.0})
        EXPECT_NEAR(estimate_over_truth(40, 2.0, power), 1.0, 0.1) << "variance by weight^" << -power;
}

TEST(LayerMean, StudentsIntervalsAreThoseOfTables) {
    EXPECT_NEAR(student(2) * 1.96, 12.706, 0.02);
    EXPECT_NEAR(student(4) * 1.96, 3.182, 0.02);
    EXPECT_NEAR(student(6) * 1.96, 2.571, 0.03);
    EXPECT_NEAR(student(11) * 1.96, 2.228, 0.02);
    EXPECT_NEAR(student(61) * 1.96, 2.000, 0.02);
}

/// What later images of a sequence take back is no error of the mean, and is not taken for one.
TEST(LayerMean, ImagesOfASequenceMayContinueEachOther) {
    ref::Random random(5);
    LayerMean mean;
    std::vector<std::vector<Layer>> first;
    for (int k = 0; k < LayerMean::sequences; ++k) {
        first.push_back(noisy(random, 3000, 0.2));
        mean.add(first.back(), 1.0, 0);
    }
    const double before = mean.relative_mean_square_error();
    for (std::vector<Layer>& layers : first) {
        for (float& value : layers.front().pixels) value = 4.0F - value;
        mean.add(layers, 1.0, 0);
    }
    EXPECT_GT(before, 1e-3);
    EXPECT_LT(mean.relative_mean_square_error(), 1e-6 * before);
    const std::vector<Layer> layers = mean.take();
    for (const float value : layers.front().pixels) EXPECT_NEAR(value, 2.0F, 1e-5F);
}

/// Generation g has 2^(g + 1) images, which share an error of standard deviation shared / 2^(g / 2), beside noise of
/// their own.
double estimate_with_shared_errors(int generations, double shared, double sigma) {
    ref::Random random(7);
    constexpr std::size_t size = 30000;
    LayerMean mean;
    for (int g = 0; g < generations; ++g) {
        const std::vector<Layer> common = noisy(random, size, shared * std::exp2(-0.5 * g));
        for (int k = 0; k < 2 << g; ++k) {
            std::vector<Layer> image = noisy(random, size, sigma);
            for (std::size_t i = 0; i < size; ++i) image.front().pixels[i] += common.front().pixels[i] - 2.0F;
            mean.add(image, 1.0, g);
        }
    }
    const double estimate = mean.relative_mean_square_error();
    double truth = 0;
    const std::vector<Layer> layers = mean.take();
    for (const float value : layers.front().pixels) truth += (value - 2.0) * (value - 2.0) / (4.04 * static_cast<double>(size));
    return estimate / truth;
}

/// The estimate takes shared errors to have one sign in all generations; these are independent.
TEST(LayerMean, SeesWhatGenerationsShare) {
    for (const double sigma : {0.02, 0.2, 0.6}) {
        const double ratio = estimate_with_shared_errors(4, 0.1, sigma);
        EXPECT_GT(ratio, 0.95) << "noise " << sigma;
        EXPECT_LT(ratio, 4.0) << "noise " << sigma;
    }
    EXPECT_NEAR(estimate_with_shared_errors(4, 0.0, 0.2), 1.0, 0.1) << "nothing shared";
}

/// One of 100 pixels varies so much more that most of the noise is its own; a dark one varies little, but much for what it shows.
TEST(LayerMean, NoisyPixelsStandOut) {
    ref::Random random(7);
    LayerMean mean;
    for (int k = 0; k < 6; ++k) {
        EXPECT_TRUE(k > 1 || mean.noisy_pixels(16).empty()) << "one image has no spread";
        std::vector<Layer> layers = noisy(random, 300, 0.02);
        for (std::size_t c = 0; c < 3; ++c) {
            layers.front().pixels[3 * 40 + c] += static_cast<float>(k % 2);
            layers.front().pixels[3 * 60 + c] = 0.3F * static_cast<float>(k % 2);
        }
        mean.add(layers, 1.0, 0);
    }
    const std::vector<unsigned char> found = mean.noisy_pixels(16);
    ASSERT_EQ(found.size(), 100U);
    for (std::size_t p = 0; p < found.size(); ++p) EXPECT_EQ(found[p] != 0, p == 40 || p == 60) << p;
}

TEST(LayerMean, NoPixelStandsOutOfEvenNoise) {
    ref::Random random(8);
    LayerMean mean;
    for (int k = 0; k < 4; ++k) mean.add(noisy(random, 30000, 0.2), 1.0, 0);
    EXPECT_TRUE(mean.noisy_pixels(16).empty());
}

TEST(LayerMean, BlackImagesHaveNoError) {
    LayerMean mean;
    for (int k = 0; k < 2; ++k) mean.add({Layer{"", 3, {0, 0, 0}}}, 1.0, 0);
    EXPECT_EQ(mean.relative_mean_square_error(), 0.0);
}

/// A rare event that one image shows makes a value wrong, not right by being bright.
TEST(LayerMean, ErrorsOfOutliersAreRelativeToWhatTheOthersShow) {
    ref::Random random(9);
    LayerMean mean;
    for (int k = 0; k < 8; ++k) {
        std::vector<Layer> image = noisy(random, 3000, 0.02);
        if (k == 5)
            for (std::size_t i = 0; i < 30; ++i) image.front().pixels[i] = 2.0F + 8 * 20.0F;
        mean.add(std::move(image), 1.0, 0, k);
    }
    const double truth = 0.01 * 20.0 * 20.0 / 4.0;
    EXPECT_NEAR(mean.relative_mean_square_error() / truth, 1.0, 0.2);
    EXPECT_NEAR(mean.usual_values()[0], 2.0F, 0.1F);
    EXPECT_NEAR(mean.usual_values()[100], 2.0F, 0.1F);
    EXPECT_EQ(mean.usual_values()[100], mean.beauty()[100]);
}

/// Spots of one set, which lies in all sequences: they are spread, the sum stays, and the error is about known.
TEST(LayerMean, SpotsOfASetAreSpread) {
    constexpr int width = 50;
    ref::Random random(11);
    LayerMean mean;
    std::vector<std::size_t> spots;
    for (int set = 0, image = 0; set < 6; ++set) {
        spots.clear();
        for (int k = 0; k < 20; ++k)
            spots.push_back(static_cast<std::size_t>((20 * set + k) * 827 % (width * width)));  // all of them apart
        for (int k = 0; k < 4; ++k, ++image) {
            std::vector<Layer> layers = noisy(random, 3 * width * width, 0.2);
            layers.push_back({indirect_layer, 3, layers.front().pixels});
            for (Layer& layer : layers)
                for (const std::size_t spot : spots)
                    for (std::size_t c = 0; c < 3; ++c) layer.pixels[3 * spot + c] += 60.0F;
            mean.add(std::move(layers), 1.0, 0, set);
        }
    }
    const double truth = 2.0 + 20 * 60.0 / (width * width);
    const auto error = [&](const LayerMean& of) {
        double sum = 0;
        for (const float v : of.beauty())
            sum += (static_cast<double>(v) - truth) * (static_cast<double>(v) - truth) / (1.01 * truth * truth);
        return sum / static_cast<double>(of.beauty().size());
    };
    const auto sum = [](const std::vector<float>& v) { return std::accumulate(v.begin(), v.end(), 0.0); };
    LayerMean spread = mean;
    spread.spread_outliers(width);
    EXPECT_LT(error(spread), 0.1 * error(mean));
    EXPECT_NEAR(sum(spread.beauty()) / sum(mean.beauty()), 1.0, 1e-4);
    EXPECT_GT(spread.relative_mean_square_error(), 0.3 * error(spread));
    EXPECT_LT(spread.relative_mean_square_error(), 3.0 * error(spread));
    const std::vector<Layer> layers = spread.take();
    for (std::size_t i = 0; i < layers[0].pixels.size(); ++i) EXPECT_NEAR(layers[0].pixels[i], layers[1].pixels[i], 1e-3F);
}

}  // namespace
