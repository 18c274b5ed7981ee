// When a series of bounces has converged, what is left of it, and how one without a sum is told.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "film/bounce_series.h"

namespace pencil {
namespace {

BounceSeries series_of(const std::vector<double>& means) {
    BounceSeries series;
    for (const double m : means) series.add(glm::dvec3(m));
    return series;
}

TEST(BounceSeries, GeometricSeriesKnowsItsTail) {
    const BounceSeries series = series_of({8, 4, 2, 1});
    EXPECT_NEAR(series.last_share(), 1.0 / 15.0, 1e-12);
    EXPECT_NEAR(series.tail_factor().x, 1.0, 1e-12);
    EXPECT_NEAR(series.tail_share(), 1.0 / 16.0, 1e-12);
    EXPECT_FALSE(series.diverges());
}

TEST(BounceSeries, NothingOrNoLightDoesNotDiverge) {
    EXPECT_FALSE(BounceSeries().diverges());
    EXPECT_FALSE(series_of({0, 0, 0}).diverges());
    EXPECT_EQ(BounceSeries().last_share(), 1.0);
}

TEST(BounceSeries, LightFromHiddenPlacesMayGrowForSomeSteps) {
    EXPECT_FALSE(series_of({0, 0.01, 0.2, 0.8, 1.0, 0.9, 0.8}).diverges());
    EXPECT_FALSE(series_of({1, 2, 3, 4, 5, 6}).diverges()) << "five steps";
}

TEST(BounceSeries, SteadyGrowthHasNoSum) {
    EXPECT_TRUE(series_of({1, 2, 3, 4, 5, 6, 7}).diverges()) << "six steps";
    BounceSeries one_channel;
    for (int k = 0; k < 7; ++k) one_channel.add({std::pow(0.5, k), std::pow(1.1, k), 1.0});
    EXPECT_TRUE(one_channel.diverges());
}

TEST(BounceSeries, FurnacesOfAlbedoOneDoNotCountAsGrowing) {
    BounceSeries series;
    for (int k = 0; k < 100; ++k) series.add(glm::dvec3(1.0 + 1e-3 * (k % 2)));
    EXPECT_FALSE(series.diverges());
}

TEST(BounceSeries, ValuesThatAreNoNumbersHaveNoSum) {
    EXPECT_TRUE(series_of({1, std::numeric_limits<double>::infinity()}).diverges());
    EXPECT_TRUE(series_of({1, std::nan("")}).diverges());
}

}  // namespace
}  // namespace pencil
