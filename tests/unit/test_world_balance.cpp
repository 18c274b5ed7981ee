// How many rays of the world set go with those of the film.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "reference/random.h"
#include "surface/world_balance.h"

namespace {

using namespace pencil;

/// The balance after sets of passes with `rays` each, whose light has this relative variance times its rays, and is `share` of the image.
WorldBalance balance_of(double noise, double rays, double share, int sets, int passes) {
    ref::Random random(5);
    WorldBalance balance;
    for (int set = 0; set < sets; ++set)
        for (int pass = 0; pass < passes; ++pass)
            balance.add(set, (10 + set) * (1 + std::sqrt(12 * noise / rays) * (random.uniform() - 0.5)), share, rays);
    return balance;
}

TEST(WorldBalance, KnowsTheNoiseWhateverTheRaysAndTheShare) {
    EXPECT_NEAR(balance_of(50, 1e4, 1, 40, 20).noise(), 50, 5);
    EXPECT_NEAR(balance_of(50, 1e6, 1, 40, 20).noise(), 50, 5);
    EXPECT_NEAR(balance_of(50, 1e4, 0.5, 40, 20).noise(), 12.5, 1.3);
    EXPECT_NEAR(balance_of(50, 1e4, 1, 400, 2).noise(), 50, 5) << "sets are lit differently: that is no noise";
}

TEST(WorldBalance, KnowsNothingOfSinglePasses) {
    EXPECT_EQ(WorldBalance().rays(1e5, 1e-3, 1e-4), 0);
    EXPECT_EQ(balance_of(50, 1e4, 1, 10, 1).rays(1e5, 1e-3, 1e-4), 0);
    EXPECT_EQ(balance_of(50, 1e4, 1, 10, 4).rays(1e5, 0, 0), 0) << "the image has no noise yet";
    WorldBalance dark;
    for (int pass = 0; pass < 4; ++pass) dark.add(0, 0, 0, 100);
    EXPECT_EQ(dark.noise(), 0);
    dark.add(0, std::numeric_limits<double>::quiet_NaN(), 0.5, 100);
    EXPECT_EQ(dark.noise(), 0);
}

/// Four times the noise: twice the rays, of either kind, where all noise of the mean is the world's.
TEST(WorldBalance, RaysGrowAsTheRootOfTheNoise) {
    constexpr double used = 1e4;
    const WorldBalance one = balance_of(50, used, 1, 40, 20), four = balance_of(200, used, 1, 40, 20);
    const double once = one.rays(1e5, 1e-2, one.noise() / used), often = four.rays(1e5, 1e-2, four.noise() / used);
    EXPECT_NEAR(often / once, 2, 0.01);
    EXPECT_NEAR(one.rays(4e5, 1e-2, one.noise() / used) / once, 2, 0.01);
    EXPECT_LT(one.rays(1e5, 4e-2, one.noise() / used), 0.6 * once) << "more noise of pixels: that is to be lowered first";
    EXPECT_LT(one.rays(1e5, 1e-2, 0.1), once) << "noise of the mean that has another cause";
    EXPECT_LT(one.rays(1e5, 1e-2, 0.01 * one.noise() / used), 0.2 * once) << "the world has no more noise than the mean";
}

}  // namespace
