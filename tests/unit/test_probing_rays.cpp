// Where probing rays start, where they point, and where on them centres lie: the distributions that placements promise.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "pencils/light_samples.h"
#include "pencils/probing_rays.h"
#include "scenes/scene_parts.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const Surface white{glm::vec3(0.5F), glm::vec3(0.0F), false}, both{glm::vec3(0.5F), glm::vec3(0.0F), true},
    black{glm::vec3(0.0F), glm::vec3(0.0F), false}, glowing{glm::vec3(0.0F), glm::vec3(1.0F), false};
constexpr int many = 4000;

FlatScene flat_of(const Scene& scene) { return flatten(scene, std::vector<LightForm>(scene.shapes.size(), LightForm::samples), 0, 0); }

/// Largest distance of the empirical distribution from the uniform one on [0, 1] (Kolmogorov and Smirnov).
double deviation_from_uniform(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    double worst = 0;
    const auto n = static_cast<double>(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        worst = std::max({worst, std::abs(values[i] - static_cast<double>(i) / n), std::abs(values[i] - static_cast<double>(i + 1) / n)});
    return worst;
}

/// What random numbers exceed in one of a hundred tests.
double critical(std::size_t count) { return 1.63 / std::sqrt(static_cast<double>(count)); }

/// Room 2 x 1 x 1 with a black floor and a black wall that emits.
Scene room() {
    Scene scene;
    for (int wall = 0; wall < 6; ++wall) add_wall(scene, wall, dvec3(0.0), {2, 1, 1}, wall == 2 ? black : wall == 4 ? glowing : white);
    look_at(scene, {0.1, 0.5, 0.5}, {1, 0.4, 0.5}, {0, 1, 0}, 60.0, 20, 10);
    return scene;
}

TEST(SurfaceRays, UniformOverTheAreaThatReflectsOrEmits) {
    const FlatScene flat = flat_of(room());
    std::map<int, int> hits;
    std::vector<double> x;
    for (const ProbingRay& ray : surface_rays(flat, {3, 2, 0}, 0, many)) {
        const dvec3 inside = ray.origin + 0.1 * ray.direction;
        int wall = -1;
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_GT(inside[axis], flat.low[axis] - 1e-9);
            EXPECT_LT(inside[axis], flat.high[axis] + 1e-9);
            if (std::abs(ray.direction[axis]) > 0.5) wall = 2 * axis + (ray.direction[axis] < 0 ? 1 : 0);
        }
        ASSERT_GE(wall, 0);
        EXPECT_NEAR(ray.origin[wall / 2], wall % 2 == 0 ? flat.low[wall / 2] : flat.high[wall / 2], 1e-6);
        if (wall == 3) x.push_back((ray.origin.x - flat.low.x) / (flat.high.x - flat.low.x));
        ++hits[wall];
    }
    EXPECT_EQ(hits.count(2), 0U) << "the black floor needs no light";
    EXPECT_GT(hits.count(4), 0U) << "the black emitter is a source of light";
    for (const auto& [wall, count] : hits) EXPECT_NEAR(count, many * (wall < 2 ? 1.0 : 2.0) / 8.0, 10.0) << "wall " << wall;
    EXPECT_LT(deviation_from_uniform(x), critical(x.size()));
}

TEST(SurfaceRays, TwoSidedSurfacesHaveRaysOnBothSidesButNotOutOfTheScene) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), both);
    add_quad(scene, "sheet", {0.5, 0.2, 0.2}, {0, 0.6, 0}, {0, 0, 0.6}, both);
    const FlatScene flat = flat_of(scene);
    const double sheet = flat.normalisation.to_scene(dvec3(0.5)).x;
    int up = 0, down = 0;
    for (const ProbingRay& ray : surface_rays(flat, {0, 2, 0}, 0, many)) {
        const Segment segment = free_segment(flat, ray, 1e9);
        EXPECT_GT(segment.high - segment.low, 0.1);
        if (std::abs(ray.origin.x - sheet) < 1e-6 && std::abs(ray.direction.x) > 0.5) ++(ray.direction.x > 0 ? up : down);
    }
    EXPECT_NEAR(up, many * 0.36 / 12.72, 8.0);
    EXPECT_NEAR(down, many * 0.36 / 12.72, 8.0);
}

TEST(SurfaceRays, DistancesAreLogUniform) {
    constexpr double extent = 1.5, length = 0.8, near = nearest_surface * extent;
    std::vector<double> exponents;
    for (const ProbingRay& ray : surface_rays(flat_of(room()), {7, 2, 1}, 0, many)) {
        const double d = log_uniform_distance({0.0, length}, ray.along, extent);
        EXPECT_GE(d, near * (1 - 1e-12));
        EXPECT_LE(d, length - near);
        exponents.push_back(std::log(d / near) / std::log((length - near) / near));
    }
    EXPECT_LT(deviation_from_uniform(exponents), critical(exponents.size()));
    EXPECT_NEAR(log_uniform_distance({0.0, 1e-4}, 0.3, extent), 5e-5, 1e-12) << "a gap too narrow has its centre in the middle";
}

TEST(LightRays, StartByPowerAndFollowTheCosine) {
    Scene scene = room();
    for (Shape& shape : scene.shapes) shape.emits = false;
    add_quad(scene, "lamp", {0.5, 0.9, 0.4}, {0.2, 0, 0}, {0, 0, 0.2}, {glm::vec3(0.0F), glm::vec3(10.0F), false});
    scene.point_lights.push_back({{1.5, 0.5, 0.5}, glm::vec3(0.1F)});
    const FlatScene flat = flat_of(scene);
    const std::vector<LightSample> lights =
        sample_lights(scene, flat, std::vector<LightForm>(scene.shapes.size(), LightForm::samples), 64, 0);
    double cosine = 0, flux = 0;
    dvec3 sphere(0.0);
    int lamp = 0;
    for (const ProbingRay& ray : light_rays(lights, {1, 3, 0}, 0, many)) {
        EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-9);
        const dvec3 at = flat.normalisation.to_world(ray.origin);
        if (std::abs(at.y - 0.9) < 1e-6) {
            ++lamp;
            EXPECT_LE(ray.direction.y, 1e-9) << "the lamp looks down";
            cosine += -ray.direction.y;
            flux += ray.direction.x;
        } else {
            EXPECT_LT(glm::distance(at, dvec3(1.5, 0.5, 0.5)), 1e-6);
            sphere += ray.direction;
        }
    }
    // Powers: pi 10 0.04 of the lamp, 4 pi 0.1 of the point light.
    EXPECT_NEAR(lamp, 0.5 * many, 20);
    EXPECT_NEAR(cosine / lamp, 2.0 / 3.0, 0.01);
    EXPECT_NEAR(flux / lamp, 0.0, 0.01);
    EXPECT_LT(glm::length(sphere) / (many - lamp), 0.02);
}

TEST(CameraRays, PassThroughTheFilmBetweenTheClippingPlanes) {
    Scene scene = room();
    scene.sensor.near_clip = 0.2;
    const FlatScene flat = flat_of(scene);
    std::vector<double> x, y;
    for (const ProbingRay& ray : camera_rays(flat.camera, {1, 4, 0}, 0, many)) {
        const dvec3 p = ray.origin - dvec3(flat.camera.origin);
        const auto row = [&](int k) { return glm::dot(dvec3(flat.to_film[static_cast<std::size_t>(k)]), p); };
        EXPECT_NEAR(row(2), static_cast<double>(flat.camera.near_clip), 1e-6);
        EXPECT_LT(glm::distance(glm::normalize(p), ray.direction), 1e-6);
        x.push_back(row(0) / row(2) / 20.0);
        y.push_back(row(1) / row(2) / 10.0);
    }
    EXPECT_LT(deviation_from_uniform(x), critical(x.size()));
    EXPECT_LT(deviation_from_uniform(y), critical(y.size()));
}

TEST(ContinuedRays, ReflectDiffuselyInProportionToTheAlbedo) {
    const double infinite = std::numeric_limits<double>::infinity();
    const std::vector<ProbingHit> hits{{dvec3(1, 0, 0), {0, 1, 0}, dvec3(0.2), 1.0},
                                       {dvec3(2, 0, 0), {0, 1, 0}, dvec3(0.6), 1.0},
                                       {dvec3(3, 0, 0), {0, 1, 0}, dvec3(0.9), infinite},
                                       {dvec3(4, 0, 0), {0, 1, 0}, dvec3(0.0), 1.0}};
    std::map<double, int> from;
    double cosine = 0;
    for (const ProbingRay& ray : continued_rays(hits, {0, 3, 1}, 0, many)) {
        ++from[ray.origin.x];
        cosine += ray.direction.y / many;
        EXPECT_GE(ray.direction.y, -1e-9);
    }
    EXPECT_NEAR(from[1], 0.25 * many, 8);
    EXPECT_NEAR(from[2], 0.75 * many, 8);
    EXPECT_NEAR(cosine, 2.0 / 3.0, 0.01);
}

TEST(ProbingRays, EachSetPlacementAndSeedHasItsOwnShift) {
    const FlatScene flat = flat_of(room());
    const auto first = [&](const ProbingStream& stream) { return surface_rays(flat, stream, 5, 1).front().origin; };
    const dvec3 origin = first({1, 2, 3});
    EXPECT_EQ(first({1, 2, 3}), origin);
    EXPECT_EQ(surface_rays(flat, {1, 2, 3}, 0, 6)[5].origin, origin) << "numbers do not depend on where a batch begins";
    for (const ProbingStream& other : {ProbingStream{2, 2, 3}, ProbingStream{1, 3, 3}, ProbingStream{1, 2, 4}})
        EXPECT_GT(glm::distance(first(other), origin), 1e-3);
}

TEST(ProbingRays, NothingToStartFromIsNothing) {
    const FlatScene empty = flat_of(Scene());
    EXPECT_TRUE(surface_rays(empty, {}, 0, 8).empty());
    EXPECT_TRUE(light_rays({}, {}, 0, 8).empty());
    EXPECT_TRUE(continued_rays({}, {}, 0, 8).empty());
    EXPECT_TRUE(continued_rays({{dvec3(0.0), {0, 1, 0}, dvec3(0.0), 1.0}}, {}, 0, 8).empty());
    Scene dark;
    add_wall(dark, 0, dvec3(0.0), dvec3(1.0), black);
    EXPECT_EQ(surface_rays(flat_of(dark), {}, 0, 8).size(), 8U) << "where nothing reflects, all surfaces count";
}

TEST(ProbingRays, SegmentsEndAtHitsBoxAndClippingPlane) {
    FlatScene flat;
    flat.low = dvec3(-1.0);
    flat.high = dvec3(1.0);
    const ProbingRay inside{dvec3(0.0), {1, 0, 0}, 0.0}, outside{{-3, 0, 0}, {1, 0, 0}, 0.0}, past{{-3, 2, 0}, {1, 0, 0}, 0.0};
    EXPECT_EQ(free_segment(flat, inside, 1e9).high, 1.0);
    EXPECT_EQ(free_segment(flat, inside, 0.25).high, 0.25);
    EXPECT_EQ(free_segment(flat, outside, 1e9).low, 2.0);
    EXPECT_EQ(free_segment(flat, outside, 1e9).high, 4.0);
    ProbingRay clipped = outside;
    clipped.longest = 2.5;
    EXPECT_EQ(free_segment(flat, clipped, 1e9).high, 2.5);
    const Segment none = free_segment(flat, past, 1e9);
    EXPECT_GE(none.low, none.high) << "beside the box";
    EXPECT_EQ(uniform_distance({2.0, 4.0}, 0.25, 1.0), 2.5);
}

}  // namespace
