// Which places are bright spots.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "surface/near_lights.h"

namespace {

using namespace pencil;

/// What rays meet: many dim points on a floor, and some bright ones about two places.
struct Met {
    std::vector<glm::vec3> points;
    std::vector<float> light;
};
Met met(int bright_points, float brightness) {
    Met m;
    for (int i = 0; i < 2000; ++i) {
        m.points.emplace_back(0.05F * static_cast<float>(i % 40), 0.0F, 0.04F * static_cast<float>(i / 40));
        m.light.push_back(1.0F);
    }
    for (int i = 0; i < bright_points; ++i) {
        const float aside = 0.02F * static_cast<float>(i % 5);
        m.points.emplace_back(i % 3 == 0 ? glm::vec3(aside, 2, 0) : glm::vec3(2 - aside, 2, 2));
        m.light.push_back(brightness);
    }
    return m;
}

TEST(FindSpots, BrightPlacesAreFoundWithTheirLight) {
    const Met m = met(30, 100);
    const std::vector<Spot> spots = find_spots(m.points, m.light, 0.5F);
    ASSERT_EQ(spots.size(), 2U);
    for (const Spot& spot : spots) {
        const bool first = spot.centre.x < 1;
        EXPECT_LT(glm::distance(spot.centre, first ? glm::vec3(0.04, 2, 0) : glm::vec3(1.96, 2, 2)), 0.03F);
        const float all = std::accumulate(m.light.begin(), m.light.end(), 0.0F);
        EXPECT_NEAR(spot.weight, 100 * (first ? 10 : 20) / all, 1e-3F) << "a share of all light";
        EXPECT_GE(spot.radius, 0.04F) << "it holds its points";
        EXPECT_LT(spot.radius, 0.3F);
    }
}

TEST(FindSpots, NoneWhereRaysFindTheLight) {
    const auto count = [](const Met& m) { return find_spots(m.points, m.light, 0.5F).size(); };
    EXPECT_EQ(count(met(0, 0)), 0U) << "even light";
    EXPECT_EQ(count(met(30, 10)), 0U) << "little of the light";
    EXPECT_EQ(count(met(400, 100)), 0U) << "seen by many";
    EXPECT_EQ(count(met(3, 10000)), 0U) << "chance";
    EXPECT_EQ(find_spots(std::vector<glm::vec3>(), std::vector<float>(), 0.5F).size(), 0U);
}

TEST(FindSpots, NoMoreThanThereIsRoomFor) {
    Met m = met(0, 0);
    m.points.resize(2000);
    for (int i = 0; i < 60; ++i) {
        m.points.emplace_back(static_cast<float>(i), 5.0F, 0.0F);
        m.light.push_back(100.0F);
    }
    EXPECT_EQ(find_spots(m.points, m.light, 0.5F).size(), static_cast<std::size_t>(SPOTS_MOST));
}

/// A plane under a light at height d, by rays to all sides, and a wall far away: what even light of the sphere sends to rings of the plane.
std::vector<LightHit> light_over_floor(float d) {
    std::vector<LightHit> hits;
    constexpr int steps = 20000;
    for (int k = 0; k < steps; ++k) {
        const float down = (static_cast<float>(k) + 0.5F) / steps, phi = 2.4F * static_cast<float>(k), distance = d / down;
        const float aside = std::sqrt(std::max(distance * distance - d * d, 0.0F));
        hits.push_back({{aside * std::cos(phi), 0, aside * std::sin(phi)}, distance, 1.0 / steps});
    }
    hits.push_back({{0, 5, 0}, 5, 1.0});
    return hits;
}

TEST(NearLightSpots, RingsHoldTheLight) {
    const std::vector<Spot> spots = near_light_spots(light_over_floor(0.01F), 1.0F);
    ASSERT_EQ(spots.size(), 2U);
    EXPECT_NEAR(spots[0].radius, 0.04F, 1e-3F);
    EXPECT_NEAR(spots[0].weight, 1 - 1 / std::sqrt(17.0), 0.01) << "of a plane under an even light";
    EXPECT_NEAR(spots[1].weight, 1 / std::sqrt(17.0) - 1 / std::sqrt(1 + 32.0 * 32.0), 0.01);
    for (const Spot& spot : spots) EXPECT_LT(glm::length(spot.centre), 1e-3F);
    EXPECT_GE(near_light_spots(light_over_floor(1e-4F), 1.0F).size(), 4U);
}

TEST(NearLightSpots, NoneFromFarOrNowhere) {
    EXPECT_TRUE(near_light_spots(light_over_floor(0.5F), 1.0F).empty());
    EXPECT_TRUE(near_light_spots({}, 1.0F).empty());
    EXPECT_TRUE(near_light_spots({{{0, 0, 0}, std::numeric_limits<float>::infinity(), 0}}, 1.0F).empty());
}

}  // namespace
