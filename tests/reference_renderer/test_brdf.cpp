// The laws of reflection, for every model: no energy is made, both directions count alike, and samples are as dense as they say.
#include <gtest/gtest.h>

#include <cmath>

#include "reference/brdf.h"
#include "reference/random.h"

namespace {

using namespace pencil;
using ref::Random;

constexpr double pi = 3.14159265358979323846;

glm::vec3 hemisphere(Random& random) {
    const double z = random.uniform(), phi = 2 * pi * random.uniform(), r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
}

std::vector<SurfaceMaterial> materials() { return {{MATERIAL_DIFFUSE, {0.2F, 0.5F, 0.9F}, false, {}}}; }

TEST(Brdf, IsSymmetric) {
    Random random(71);
    for (const SurfaceMaterial& m : materials())
        for (int i = 0; i < 100; ++i) {
            const glm::vec3 a = hemisphere(random), b = hemisphere(random);
            const glm::vec3 one = evaluate(m, a, b), other = evaluate(m, b, a);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(one[c], other[c], 1e-5F * one[c]);
        }
}

/// Against uniform directions, whose density is 1 / (2 pi sr), that is 1/2 in units of pi steradians.
TEST(Brdf, IntegralsAreTheAlbedoAndOne) {
    Random random(72);
    constexpr int count = 200000;
    for (const SurfaceMaterial& m : materials()) {
        const glm::vec3 omega_o = hemisphere(random);
        glm::dvec3 reflected(0);
        double density = 0;
        for (int i = 0; i < count; ++i) {
            const glm::vec3 omega_i = hemisphere(random);
            reflected += 2.0 * omega_i.z * glm::dvec3(evaluate(m, omega_o, omega_i)) / double(count);
            density += 2.0 * pdf(m, omega_o, omega_i) / double(count);
        }
        constexpr double noise = 5 * 0.58 / 447.0;  // five standard deviations of the mean of 2 cos
        EXPECT_NEAR(density, 1, noise);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(reflected[c], albedo(m, omega_o)[c], noise);
            EXPECT_LE(albedo(m, omega_o)[c], 1.0F);
        }
    }
}

/// The weight is what evaluate and pdf say, and moments of the directions are those of the density.
TEST(Brdf, SamplesFollowTheDensity) {
    Random random(73);
    constexpr int count = 200000;
    for (const SurfaceMaterial& m : materials()) {
        const glm::vec3 omega_o = hemisphere(random);
        glm::dvec3 sampled(0), expected(0);
        for (int i = 0; i < count; ++i) {
            const BrdfSample s = sample(m, omega_o, {random.uniform(), random.uniform()});
            ASSERT_NEAR(glm::length(s.omega_i), 1, 1e-6);
            ASSERT_FLOAT_EQ(s.pdf, pdf(m, omega_o, s.omega_i));
            for (int c = 0; c < 3; ++c) ASSERT_NEAR(s.weight[c] * s.pdf, evaluate(m, omega_o, s.omega_i)[c] * s.omega_i.z, 1e-5 * s.pdf);
            sampled += glm::dvec3(s.omega_i) / double(count);
            const glm::vec3 uniform = hemisphere(random);
            expected += 2.0 * pdf(m, omega_o, uniform) * glm::dvec3(uniform) / double(count);
        }
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(sampled[c], expected[c], 5 * 1.5 / 447.0);
    }
}

TEST(Brdf, FrameIsOrthonormalAndTurnsBothWays) {
    Random random(74);
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 h = hemisphere(random), n = i % 2 == 0 ? h : -h, v = hemisphere(random);
        const ShadingFrame frame(n);
        EXPECT_EQ(frame.to_world({0, 0, 1}), n);
        EXPECT_LT(glm::distance(frame.to_world(frame.to_local(v)), v), 1e-6F);
        const glm::vec3 x = frame.to_world({1, 0, 0}), y = frame.to_world({0, 1, 0});
        EXPECT_LT(glm::distance(glm::cross(x, y), n), 1e-6F);
    }
}

}  // namespace
