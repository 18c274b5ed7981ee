// Which places are bright spots.
#include <gtest/gtest.h>

#include "surface/spots.h"

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
        EXPECT_FLOAT_EQ(spot.weight, first ? 1.0F / 3 : 2.0F / 3);
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
    EXPECT_EQ(find_spots({}, {}, 0.5F).size(), 0U);
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

}  // namespace
