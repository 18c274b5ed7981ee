// The brute-force ray cast and visibility checked on cases whose answer is known by hand.
#include <gtest/gtest.h>

#include "reference/random.h"
#include "reference/visibility_ref.h"

namespace {

using namespace pencil::ref;
using pencil::ref::Triangle;

/// The six walls of [-1, 1]^3, two triangles each, planes 0 to 5.
std::vector<Triangle> box() {
    std::vector<Triangle> out;
    for (int wall = 0; wall < 6; ++wall) {
        const int axis = wall / 2;
        const auto corner = [&](double u, double v) {
            dvec3 p;
            p[axis] = wall % 2 == 0 ? -1.0 : 1.0;
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            return p;
        };
        out.push_back({corner(-1, -1), corner(1, -1), corner(1, 1), wall});
        out.push_back({corner(-1, -1), corner(1, 1), corner(-1, 1), wall});
    }
    return out;
}

TEST(RaycastReference, DistanceInABox) {
    Random random(3);
    const std::vector<Triangle> walls = box();
    for (int i = 0; i < 20000; ++i) {
        const dvec3 o = random.in_box(-0.99, 0.99), d = random.direction();
        double expected = 1e9;
        for (int axis = 0; axis < 3; ++axis) expected = std::min(expected, ((d[axis] > 0.0 ? 1.0 : -1.0) - o[axis]) / d[axis]);
        const RayHit hit = nearest_triangle(walls, o, d);
        ASSERT_GE(hit.triangle, 0) << "ray " << i;
        ASSERT_NEAR(hit.t, expected, 1e-9) << "ray " << i;
        ASSERT_TRUE(is_plausible(walls, o, d, hit.triangle)) << "ray " << i;
        ASSERT_FALSE(is_plausible(walls, o, d, -1) && hit.margin > 1e-5) << "ray " << i;
    }
}

TEST(RaycastReference, FarTriangleIsNotPlausible) {
    const std::vector<Triangle> two{{{-1, -1, 1}, {1, -1, 1}, {0, 2, 1}, 0}, {{-1, -1, 2}, {1, -1, 2}, {0, 2, 2}, 1}};
    const dvec3 origin(0.0), forward(0, 0, 1);
    const RayHit hit = nearest_triangle(two, origin, forward);
    EXPECT_EQ(hit.triangle, 0);
    EXPECT_DOUBLE_EQ(hit.t, 1.0);
    EXPECT_GT(hit.margin, 0.1);
    EXPECT_FALSE(is_plausible(two, origin, forward, 1));
    EXPECT_FALSE(is_plausible(two, origin, forward, -1));
    EXPECT_EQ(nearest_triangle(two, origin, {0, 0, -1}).triangle, -1);
}

TEST(RaycastReference, SharedEdgeIsATie) {
    const std::vector<Triangle> quad{{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, 0}, {{-1, -1, 1}, {1, 1, 1}, {-1, 1, 1}, 0}};
    const RayHit on_edge = nearest_triangle(quad, dvec3(0.0), {0.25, 0.25, 1});
    EXPECT_LT(on_edge.margin, 1e-9);
    EXPECT_TRUE(is_plausible(quad, dvec3(0.0), {0.25, 0.25, 1}, 0));
    EXPECT_TRUE(is_plausible(quad, dvec3(0.0), {0.25, 0.25, 1}, 1));
    EXPECT_FALSE(is_plausible(quad, dvec3(0.0), {0.25, 0.30, 1}, 0));
}

TEST(RaycastReference, PlaneThroughTheCentreIsNotSeen) {
    const std::vector<Triangle> floor{{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}, 0}};
    EXPECT_EQ(nearest_triangle(floor, {0, 0, 0}, {0, 0, 1}).triangle, -1) << "centre on the face";
    EXPECT_EQ(nearest_triangle(floor, {-1, -1, 0}, {1, 1, 0}).triangle, -1) << "centre on a corner";
    EXPECT_EQ(nearest_triangle(floor, {0, 0, 1e-8}, {0, 0, -1}).triangle, -1) << "centre within rounding of the face";
    EXPECT_EQ(nearest_triangle(floor, {0, 0, 1e-3}, {0, 0, -1}).triangle, 0);
}

TEST(VisibilityReference, WallHidesOwnPlaneDoesNot) {
    const std::vector<Triangle> scene{{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}, 7}, {{-1, -1, 1}, {1, -1, 1}, {0, 2, 1}, 8}};
    EXPECT_TRUE(segment_visibility(scene, {0, 0, 0}, {0, 0, 0.9}, {7}).visible);
    EXPECT_FALSE(segment_visibility(scene, {0, 0, 0}, {0, 0, 1.1}, {7}).visible);
    EXPECT_TRUE(segment_visibility(scene, {0, 0, 0}, {0, 0, 1.1}, {7, 8}).visible);
    EXPECT_TRUE(segment_visibility(scene, {0, 0, 0.5}, {0, 8, 2.0}, {}).visible) << "passes beside the triangle";
    EXPECT_GT(segment_visibility(scene, {0, 0, 0}, {0, 0, 1.1}, {7}).margin, 0.01);
}

TEST(VisibilityReference, AgreesWithTheRayCast) {
    Random random(4);
    const std::vector<Triangle> soup = triangle_soup(random, 60);
    for (int i = 0; i < 20000; ++i) {
        const dvec3 x = random.in_box(-1, 1), y = random.in_box(-1, 1);
        const Visibility v = segment_visibility(soup, x, y, {});
        if (v.margin < 1e-7) continue;
        ASSERT_EQ(v.visible, !(nearest_triangle(soup, x, y - x).t < 1.0)) << "segment " << i << " margin " << v.margin;
    }
}

}  // namespace
