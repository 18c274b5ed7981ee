// Which places are portals.
#include <gtest/gtest.h>

#include <cmath>

#include "pencils/low_discrepancy.h"
#include "surface/portals.h"

namespace {

using namespace pencil;

/// From places in a room 4 wide, 3 high and 5 deep, rays in all directions; those through a window of width `opening` in the wall x = 0 are bright, with 64
/// times the light of others, and end far away.
std::vector<LightRay> rays_of_room(float opening, float other) {
    const glm::vec3 window(0, 1.5F, 2.5F);
    std::vector<LightRay> rays;
    const auto unit = [](int stream, int index) {
        return static_cast<float>(random_unit(7, static_cast<std::uint64_t>(stream), static_cast<std::uint64_t>(index)));
    };
    for (int k = 0; k < 20000; ++k) {
        const glm::vec3 origin(4 * unit(1, k), 3 * unit(2, k), 5 * unit(3, k));
        const float z = 2 * unit(4, k) - 1, phi = 6.2831853F * unit(5, k), flat = std::sqrt(1 - z * z);
        const glm::vec3 direction(flat * std::cos(phi), flat * std::sin(phi), z);
        const float t = direction.x < 0 ? -origin.x / direction.x : -1;
        const glm::vec3 step = origin + t * direction - window;
        const bool through = t > 0 && std::abs(step.y) < opening / 2 && std::abs(step.z) < opening / 2;
        rays.push_back({origin, direction, through ? 1e3F : 2.0F, through ? 64.0F : other, through ? 1.0F : 0.0F});
    }
    return rays;
}

TEST(FindPortals, AWindowIsFoundWhereRaysPass) {
    const std::vector<Spot> portals = find_portals(rays_of_room(0.8F, 0.0F), 1);
    ASSERT_FALSE(portals.empty());
    float weight = 0;
    for (const Spot& p : portals) {
        EXPECT_LT(glm::distance(p.centre, glm::vec3(0, 1.5F, 2.5F)), 0.5F);
        EXPECT_LT(p.radius, 0.8F);
        EXPECT_GT(p.radius, 0.1F);
        EXPECT_FLOAT_EQ(p.emission, 1);
        weight += p.weight;
    }
    EXPECT_GT(weight, 0.5F);
    EXPECT_LE(weight, 1.001F);
}

TEST(FindPortals, NoneWhereRaysInAllDirectionsFindTheLight) {
    EXPECT_TRUE(find_portals(rays_of_room(0.8F, 4.0F), 1).empty()) << "most light comes from elsewhere";
    EXPECT_TRUE(find_portals({}, 1).empty());
    EXPECT_TRUE(find_portals(rays_of_room(0.02F, 0.0F), 1).empty()) << "a ray or two";
}

/// Rays that are bright by chance meet nowhere.
TEST(FindPortals, NoneAmongBrightRaysThatMeetNowhere) {
    std::vector<LightRay> rays = rays_of_room(0, 0);
    for (std::size_t i = 0; i < rays.size(); i += 40) rays[i].light = 64;
    EXPECT_TRUE(find_portals(rays, 1).empty());
}

/// What rays end at is a portal, too, wherever they come from; rays that start beside it say nothing.
TEST(FindPortals, ALampIsOne) {
    std::vector<LightRay> rays = rays_of_room(0, 0);
    const glm::vec3 lamp(2, 2, 2);
    for (std::size_t i = 0; i < rays.size(); i += 20) {
        const float distance = glm::distance(rays[i].origin, lamp);
        rays[i] = {rays[i].origin, (lamp - rays[i].origin) / distance, distance, 64, 0.5F};
    }
    const std::vector<Spot> portals = find_portals(rays, 1);
    ASSERT_EQ(portals.size(), 1U);
    EXPECT_LT(glm::distance(portals.front().centre, lamp), 1e-3F);
    EXPECT_NEAR(portals.front().emission, 0.5F, 1e-3F);
}

/// Rays that spots or portals are known for need no further ones.
TEST(FindPortals, NoneWhereTheyAreKnown) {
    const std::vector<LightRay> rays = rays_of_room(0.8F, 0.0F);
    EXPECT_TRUE(find_portals(rays, 1, {{{0, 1.5F, 2.5F}, 0.6F, 1}}).empty());
    EXPECT_FALSE(find_portals(rays, 1, {{{0, 1.5F, 4.5F}, 0.6F, 1}}).empty());
}

TEST(Spots, ShineWhereMuchIsEmitted) {
    DeviceSpots spots;
    EXPECT_FALSE(spots.shine());
    spots.found = {{glm::vec3(0), 1, 0.9F, 0}, {glm::vec3(0), 1, 0.01F, 1}};
    EXPECT_FALSE(spots.shine());
    spots.found[1].weight = 0.5F;
    EXPECT_TRUE(spots.shine());
}

}  // namespace
