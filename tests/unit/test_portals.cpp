// Which places are portals.
#include <gtest/gtest.h>

#include <cmath>

#include "pencils/low_discrepancy.h"
#include "surface/portals.h"

namespace {

using namespace pencil;

constexpr int of_each = 64, pencils = 400;

/// In a room 4 wide, 3 high and 5 deep, rays of pencils in all directions; those through a window of width `opening` in the wall x = 0 bring `bright`, and end
/// far away, all others 1.
std::vector<LightRay> rays_of_room(float opening, float bright) {
    const glm::vec3 window(0, 1.5F, 2.5F);
    std::vector<LightRay> rays;
    const auto unit = [](int stream, int index) {
        return static_cast<float>(random_unit(7, static_cast<std::uint64_t>(stream), static_cast<std::uint64_t>(index)));
    };
    for (int k = 0; k < pencils * of_each; ++k) {
        const int pencil = k / of_each;
        const glm::vec3 origin(4 * unit(1, pencil), 3 * unit(2, pencil), 5 * unit(3, pencil));
        const float z = 2 * unit(4, k) - 1, phi = 6.2831853F * unit(5, k), flat = std::sqrt(1 - z * z);
        const glm::vec3 direction(flat * std::cos(phi), flat * std::sin(phi), z);
        const float t = direction.x < 0 ? -origin.x / direction.x : -1;
        const glm::vec3 step = origin + t * direction - window;
        const bool through = t > 0 && std::abs(step.y) < opening / 2 && std::abs(step.z) < opening / 2;
        rays.push_back({origin, direction, glm::vec3(0, 1, 0), through ? 1e3F : 2.0F, through ? bright : 1.0F, through ? 1.0F : 0.0F});
    }
    return rays;
}

std::vector<Spot> find(const std::vector<LightRay>& rays, const std::vector<Spot>& known = {}) {
    return find_portals(rays, of_each, {1, 1}, known);
}

TEST(FindPortals, AWindowIsFoundWhereRaysPass) {
    const std::vector<Spot> portals = find(rays_of_room(0.8F, 200));
    ASSERT_FALSE(portals.empty());
    float weight = 0;
    for (const Spot& p : portals) {
        EXPECT_LT(glm::distance(p.centre, glm::vec3(0, 1.5F, 2.5F)), 0.5F);
        EXPECT_LT(p.radius, 0.8F);
        EXPECT_GT(p.radius, 0.1F);
        EXPECT_FLOAT_EQ(p.emission, 1);
        weight += p.weight;
    }
    EXPECT_GT(weight, 0.15F) << "of each pencil's light, in the mean";
    EXPECT_LE(weight, 1);
}

/// Bright is what is so for pencils nearby that face the same way: pencils of a room a thousand times as bright, elsewhere or on the other side of its
/// walls, say nothing of a dark one.
TEST(FindPortals, BrightRoomsNearbyHideNothing) {
    std::vector<LightRay> dark = rays_of_room(0.8F, 200);
    for (LightRay& ray : dark) ray.light *= 1e-3F;
    const std::vector<Spot> alone = find(dark);
    ASSERT_FALSE(alone.empty());
    for (const bool elsewhere : {true, false}) {
        std::vector<LightRay> rays = dark;
        for (LightRay ray : rays_of_room(0, 0)) {
            if (elsewhere)
                ray.origin.x += 100;
            else
                ray.normal = -ray.normal;
            rays.push_back(ray);
        }
        const std::vector<Spot> portals = find(rays);
        ASSERT_EQ(portals.size(), alone.size());
        EXPECT_EQ(portals[0].centre, alone[0].centre);
        EXPECT_NEAR(portals[0].weight, alone[0].weight / 2, 1e-3F) << "half of the light that pencils receive is the others'";
    }
}

TEST(FindPortals, NoneWhereRaysInAllDirectionsFindTheLight) {
    EXPECT_TRUE(find(rays_of_room(0.8F, 10)).empty()) << "most light comes from elsewhere";
    EXPECT_TRUE(find(rays_of_room(2.9F, 10)).empty()) << "many rays of each pencil find it";
    EXPECT_TRUE(find({}).empty());
    EXPECT_TRUE(find(rays_of_room(0.02F, 1e4F)).empty()) << "a ray or two";
}

/// Rays that are bright by chance meet nowhere.
TEST(FindPortals, NoneAmongBrightRaysThatMeetNowhere) {
    std::vector<LightRay> rays = rays_of_room(0, 0);
    for (std::size_t i = 0; i < rays.size(); i += 41) rays[i].light = 64;
    EXPECT_TRUE(find(rays).empty());
}

/// What rays end at is a portal, too, wherever they come from; rays that start beside it say nothing, nor do those that lobes have turned.
TEST(FindPortals, ALampIsOne) {
    std::vector<LightRay> rays = rays_of_room(0, 0);
    const glm::vec3 lamp(2, 2, 2);
    for (std::size_t i = 0; i < rays.size(); i += 41) {
        const float distance = glm::distance(rays[i].origin, lamp);
        rays[i] = {rays[i].origin, (lamp - rays[i].origin) / distance, rays[i].normal, distance, 64, 0.5F};
    }
    const std::vector<Spot> portals = find(rays);
    ASSERT_EQ(portals.size(), 1U);
    EXPECT_LT(glm::distance(portals.front().centre, lamp), 1e-3F);
    EXPECT_NEAR(portals.front().emission, 0.5F, 1e-3F);
    for (LightRay& ray : rays) ray.turned = ray.light > 1;
    EXPECT_TRUE(find(rays).empty());
}

/// Rays that spots or portals are known for need no further ones.
TEST(FindPortals, NoneWhereTheyAreKnown) {
    const std::vector<LightRay> rays = rays_of_room(0.8F, 200);
    EXPECT_TRUE(find(rays, {{{0, 1.5F, 2.5F}, 0.6F, 1}}).empty());
    EXPECT_FALSE(find(rays, {{{0, 1.5F, 4.5F}, 0.6F, 1}}).empty());
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
