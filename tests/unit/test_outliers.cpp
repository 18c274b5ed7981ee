// What one image of several shows far above the others, against images whose truth is known.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "film/outliers.h"
#include "reference/random.h"

namespace {

using namespace pencil;

constexpr int width = 40, height = 30, kinds = 4;
constexpr std::size_t pixels = static_cast<std::size_t>(width) * height;

/// Images of noise about 1, relative, but for their left quarter, which is known to be 1.
std::vector<ImageValues> noisy(double sigma) {
    ref::Random random(7);
    std::vector<ImageValues> images(kinds, ImageValues(3 * pixels, 1.0F));
    for (ImageValues& image : images)
        for (std::size_t i = 0; i < pixels; ++i)
            if (i % width >= width / 4)
                for (std::size_t c = 0; c < 3; ++c)
                    image[3 * i + c] += static_cast<float>(sigma * std::sqrt(12.0) * (random.uniform() - 0.5));
    return images;
}

std::size_t at(int x, int y) { return static_cast<std::size_t>(y * width + x); }

void set(ImageValues& image, std::size_t i, float r, float g, float b) {
    image[3 * i] = r;
    image[3 * i + 1] = g;
    image[3 * i + 2] = b;
}

double sum(const ImageValues& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double largest(const ImageValues& values) {
    double most = 0;
    for (const float v : values) most = std::max(most, std::abs(static_cast<double>(v)));
    return most;
}

TEST(Outliers, NoiseStaysAsItIs) {
    for (const ImageValues& steps : spread_outliers(noisy(0.2), width).steps) EXPECT_EQ(largest(steps), 0.0);
}

TEST(Outliers, AreSpreadWithinTheNoise) {
    std::vector<ImageValues> images = noisy(0.1);
    set(images[2], at(25, 12), 60.0F, 40.0F, 20.0F);
    const std::vector<ImageValues> steps = spread_outliers(images, width).steps;
    for (const std::size_t other : {0, 1, 3}) EXPECT_EQ(largest(steps[other]), 0.0);
    EXPECT_NEAR(sum(steps[2]), 0.0, 1e-2) << "of 120 that were moved";
    EXPECT_NEAR(images[2][3 * at(25, 12)] + steps[2][3 * at(25, 12)], 3.4, 0.2) << "twice what all show about it, of its own colour";
    int known = 0, wrong = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        if (i == at(25, 12)) continue;
        known += i % width < width / 4 && steps[2][3 * i] == 0.0F ? 1 : 0;
        wrong += steps[2][3 * i] > 0.2F ? 1 : 0;
    }
    EXPECT_EQ(known, width / 4 * height) << "what is known stays";
    EXPECT_EQ(wrong, 0);
    set(images[2], at(25, 12), 3e4F, 2e4F, 1e4F);
    EXPECT_EQ(largest(spread_outliers(images, width).steps[2]), 0.0) << "more than all noise of the image can hide";
}

TEST(Outliers, OfFewAreSpreadNearby) {
    std::vector<ImageValues> images = noisy(0.1);
    set(images[0], at(25, 12), 3.0F, 3.0F, 3.0F);
    const std::vector<ImageValues> steps = spread_outliers(images, width).steps;
    EXPECT_LT(steps[0][3 * at(25, 12)], -0.5F);
    EXPECT_EQ(steps[0][3 * at(35, 25)], 0.0F);
}

/// What is bright in all images is no outlier, nor is what lies at its edge.
TEST(Outliers, BrightThingsAndTheirEdgesStay) {
    std::vector<ImageValues> images = noisy(0.1);
    for (ImageValues& image : images)
        for (int y = 0; y < height; ++y) set(image, at(20, y), 90.0F, 90.0F, 90.0F);
    set(images[1], at(21, 9), 80.0F, 80.0F, 80.0F);
    for (const ImageValues& steps : spread_outliers(images, width).steps) EXPECT_EQ(largest(steps), 0.0);
}

TEST(Outliers, NothingChangesWhereNothingHasNoise) {
    std::vector<ImageValues> images(kinds, ImageValues(3 * pixels, 0.0F));
    EXPECT_EQ(largest(spread_outliers(images, width).steps[0]), 0.0);
    set(images[3], at(0, 0), 1e30F, 0.0F, 0.0F);
    for (const ImageValues& steps : spread_outliers(images, width).steps)
        for (const float step : steps) EXPECT_TRUE(std::isfinite(step));
}

}  // namespace
