// Readings and fits of curves with a known law.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "converge/curve.h"

namespace pencil {
namespace {

/// error^2 = floor^2 + (scale t^slope)^2 at doublings of time from 0.1 s, each times exp(`scatter` * normal).
Curve synthetic(int points, double scale, double slope, double floor, double scatter = 0) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    Curve curve;
    for (int i = 0; i < points; ++i) {
        const double seconds = 0.1 * std::pow(2, i);
        curve.push_back({seconds, std::hypot(floor, scale * std::pow(seconds, slope)) * std::exp(scatter * normal(random))});
    }
    return curve;
}

TEST(Curve, PowerLawIsRecovered) {
    const std::optional<PowerLaw> law = fit_power_law(synthetic(6, 0.03, -0.5, 0));
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->slope, -0.5, 1e-12);
    EXPECT_NEAR(law->coefficient, 0.03, 1e-12);
}

TEST(Curve, LawsNeedTwoTimes) {
    EXPECT_FALSE(fit_power_law({}));
    EXPECT_FALSE(fit_power_law({{1, 2}}));
    EXPECT_FALSE(fit_power_law({{1, 2}, {1, 3}}));
    EXPECT_FALSE(fit_floor(synthetic(3, 1, -0.5, 0)));
}

TEST(Curve, FloorIsFound) {
    const std::optional<FloorFit> fit = fit_floor(synthetic(7, 0.05, -0.5, 0.04));
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->visible);
    EXPECT_NEAR(fit->floor, 0.04, 0.001);
    EXPECT_NEAR(fit->exponent, 0.5, 0.02);
    EXPECT_NEAR(fit->coefficient, 0.05, 0.002);
}

TEST(Curve, FloorIsFoundInScatter) {
    const std::optional<FloorFit> fit = fit_floor(synthetic(8, 0.05, -0.5, 0.04, 0.03));
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->visible);
    EXPECT_NEAR(fit->floor, 0.04, 0.006);
}

TEST(Curve, NoFloorIsSeenInAPowerLaw) {
    for (const double slope : {-0.1, -0.25, -0.5, -1.0}) {
        for (const double scatter : {0.0, 0.05}) {
            const std::optional<FloorFit> fit = fit_floor(synthetic(7, 0.05, slope, 0, scatter));
            ASSERT_TRUE(fit);
            EXPECT_FALSE(fit->visible) << slope << " " << scatter << " floor " << fit->floor;
        }
    }
}

TEST(Curve, NoFloorIsSeenFarBelowTheLastError) {
    const Curve curve = synthetic(7, 0.05, -0.5, 0.002);
    EXPECT_FALSE(fit_floor(curve)->visible);
}

TEST(Curve, AFloorThatTheLastErrorFellBelowIsNone) {
    Curve curve = synthetic(7, 0.05, -0.5, 0.04);
    ASSERT_TRUE(fit_floor(curve)->visible);
    curve.back().error = 0.035;
    EXPECT_FALSE(fit_floor(curve)->visible) << fit_floor(curve)->floor;
}

TEST(Curve, AnErrorThatDoesNotFallIsAFloor) {
    const std::optional<FloorFit> fit = fit_floor(synthetic(6, 0, -0.5, 0.3, 0.01));
    ASSERT_TRUE(fit);
    EXPECT_TRUE(fit->visible);
    EXPECT_NEAR(fit->floor, 0.3, 0.01);
}

TEST(Curve, ErrorsBetweenPointsFollowThePowerLaw) {
    const Curve curve = synthetic(6, 0.03, -0.5, 0);
    for (const double seconds : {0.1, 0.17, 1.0, 3.2}) {
        const Reading reading = error_at(curve, seconds);
        EXPECT_EQ(reading.kind, Reading::Kind::measured) << seconds;
        EXPECT_NEAR(reading.value, 0.03 / std::sqrt(seconds), 1e-12) << seconds;
        const Reading back = time_to(curve, reading.value);
        EXPECT_EQ(back.kind, Reading::Kind::measured) << seconds;
        EXPECT_NEAR(back.value, seconds, 1e-9);
    }
}

TEST(Curve, NothingIsReadOffOutsideTheRange) {
    const Curve curve = synthetic(6, 0.03, -0.5, 0);
    EXPECT_EQ(error_at(curve, 0.095).kind, Reading::Kind::before_first);
    EXPECT_EQ(error_at(curve, 0.095).value, 0.1);
    EXPECT_EQ(error_at(curve, 3.37).kind, Reading::Kind::not_reached);
    EXPECT_NEAR(error_at(curve, 3.37).value, 3.2, 1e-12);
    EXPECT_NEAR(error_at(curve, 3.3).value, curve.back().error, 1e-12) << "within 5 % of the last point";
    EXPECT_NEAR(error_at(curve, 0.097).value, curve.front().error, 1e-12);
    EXPECT_EQ(time_to(curve, 0.2).kind, Reading::Kind::before_first);
    EXPECT_EQ(time_to(curve, 0.001).kind, Reading::Kind::not_reached);
    EXPECT_EQ(error_at({}, 1).kind, Reading::Kind::not_reached);
    EXPECT_EQ(time_to({}, 1).kind, Reading::Kind::not_reached);
}

TEST(Curve, TheFirstCrossingCounts) {
    const Curve curve{{1, 8}, {2, 2}, {4, 8}, {8, 1}};
    EXPECT_NEAR(time_to(curve, 4).value, std::sqrt(2.0), 1e-12);
    EXPECT_NEAR(time_to(curve, 1).value, 8, 1e-12);
}

TEST(Curve, UnusablePointsAreDropped) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Curve curve = make_curve({{2, 1}, {1, 3}, {3, nan}, {0, 1}, {4, 0}});
    ASSERT_EQ(curve.size(), 2U);
    EXPECT_EQ(curve[0].seconds, 1);
}

}  // namespace
}  // namespace pencil
