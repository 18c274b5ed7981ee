// Where sensors lie: points where they are, shapes evenly over their front.
#include <glm/geometric.hpp>

#include "pencils/low_discrepancy.h"
#include "scene/sensor_places.h"
#include "scenes/scene_parts.h"

namespace pencil::test {
namespace {

TEST(SensorPlaces, PointsAreWhereTheyAre) {
    Scene scene;
    SensorPoint point;
    point.position = {1, 2, 3};
    point.normal = {0, 1, 0};
    scene.sensor_points.push_back(point);
    const SensorPlaces places(scene);
    EXPECT_EQ(places.at(0, {0.3, 0.9}).position, point.position);
    EXPECT_EQ(places.at(0, {0.3, 0.9}).normal, point.normal);
    EXPECT_EQ(middle_of_sensors(scene), point.position);
}

/// Two quads of one shape, one of three times the area of the other: places are on them, and as many as their areas say on each half.
TEST(SensorPlaces, ShapesAreCoveredEvenly) {
    Scene scene;
    add_quad(scene, "other", {5, 5, 5}, {1, 0, 0}, {0, 1, 0}, {});
    const dvec3 a(0, 0, 0), u(3, 0, 0), v(0, 2, 0), b(0, 0, 1), w(1, 0, 0);
    add_shape(scene, "measured", {{a, a + u, a + u + v}, {a, a + u + v, a + v}, {b, b + w, b + w + v}, {b, b + w + v, b + v}}, {});
    SensorPoint meter;
    meter.shape = 1;
    scene.sensor_points.push_back(meter);
    const SensorPlaces places(scene);
    ASSERT_TRUE(places.is_shape(0));
    constexpr int count = 4000;
    int large = 0, left = 0;
    dvec3 sum(0);
    for (std::uint64_t i = 0; i < count; ++i) {
        const SensorPlace place = places.at(0, r2_sequence(i, {0.1, 0.7}));
        EXPECT_NEAR(glm::length(place.normal - dvec3(0, 0, 1)), 0, 1e-12);
        const bool on_large = place.position.z < 0.5;
        ASSERT_NEAR(place.position.z, on_large ? 0 : 1, 1e-12);
        ASSERT_TRUE(place.position.x >= 0 && place.position.x <= (on_large ? 3 : 1) && place.position.y >= 0 && place.position.y <= 2);
        large += on_large ? 1 : 0;
        left += on_large && place.position.x < 1.5 ? 1 : 0;
        if (on_large) sum += place.position;
    }
    EXPECT_NEAR(large, 0.75 * count, 0.01 * count);
    EXPECT_NEAR(left, 0.5 * large, 0.01 * count);
    EXPECT_NEAR(sum.x / large, 1.5, 0.02);
    EXPECT_NEAR(sum.y / large, 1, 0.02);
}

}  // namespace
}  // namespace pencil::test
