// The certified error of few pixels that are looked at many times: unbiased, and its interval holds the truth.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "certify/known_pixels.h"

namespace pencil {
namespace {

/// Four pixels of value 1 whose truth is 1 - bias, looked at `count` times with noise of this deviation, all channels alike.
std::vector<PixelLooks> looks(double bias, double noise, int count, unsigned seed) {
    std::mt19937 engine(seed);
    std::normal_distribution<double> normal(bias, noise);
    std::vector<PixelLooks> all(4);
    for (PixelLooks& of : all)
        for (int i = 0; i < count; ++i) of.add(glm::dvec3(normal(engine)));
    return all;
}

CertifiedError certified(double bias, double noise, int count, unsigned seed) {
    return certify_pixels(looks(bias, noise, count, seed), std::vector<float>(12, 1.0F), 1.0);
}

TEST(KnownPixels, IntervalsHoldTheError) {
    for (const double bias : {0.0, 0.02, 0.2}) {
        const double expected = bias * bias / 1.01;  // relative to r^2 + 0.01 m^2
        int squares_held = 0, steps_held = 0;
        double mean = 0;
        constexpr int runs = 400;
        for (unsigned run = 0; run < runs; ++run) {
            const CertifiedError found = certified(bias, 0.3, 50, run);
            EXPECT_EQ(found.points, 100);
            mean += found.relmse / runs;
            squares_held += std::abs(found.relmse - expected) <= interval_errors * found.standard_error ? 1 : 0;
            steps_held += std::abs(found.mean_bias - bias) <= interval_errors * found.mean_error ? 1 : 0;
        }
        EXPECT_NEAR(mean, expected, 2e-4 + 0.01 * bias) << "unbiased, bias " << bias;
        EXPECT_GE(squares_held, runs * 90 / 100) << "bias " << bias;
        EXPECT_GE(steps_held, runs * 92 / 100) << "bias " << bias;
    }
}

TEST(KnownPixels, NothingIsKnownOfWhatWasSeenOnce) {
    EXPECT_EQ(certified(0.1, 0.3, 1, 1).points, 0);
    std::vector<PixelLooks> some = looks(0.1, 0.0, 10, 1);
    some[2] = PixelLooks();
    const CertifiedError found = certify_pixels(some, std::vector<float>(12, 1.0F), 1.0);
    EXPECT_EQ(found.points, 15);
    EXPECT_NEAR(found.relmse, 0.01 / 1.01, 1e-12);
    EXPECT_NEAR(found.standard_error, 0, 1e-9);
}

}  // namespace
}  // namespace pencil
