// Samples that continue each other from turn to turn: Sobol's points, light samples, and points thinned to a spacing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "pencils/light_samples.h"
#include "pencils/low_discrepancy.h"
#include "pencils/thin_points.h"
#include "scenes/scene_parts.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// Every box of area 2^-m, whatever its shape, holds one of any 2^m points that begin at a multiple of 2^m.
TEST(Sobol2d, IsAZeroTwoSequence) {
    for (std::uint32_t m = 0; m <= 8; ++m)
        for (std::uint32_t begin : {0U, 1U << m, 5U << m})
            for (std::uint32_t columns = 0; columns <= m; ++columns) {
                std::set<std::uint32_t> boxes;
                for (std::uint32_t i = begin; i < begin + (1U << m); ++i) {
                    const glm::uvec2 p = sobol_2d(i);
                    const auto top = [](std::uint32_t v, std::uint32_t bits) { return bits == 0 ? 0 : v >> (32 - bits); };
                    boxes.insert(top(p.x, columns) << (m - columns) | top(p.y, m - columns));
                }
                EXPECT_EQ(boxes.size(), 1U << m) << "m = " << m << ", 2^" << columns << " columns";
            }
}

/// A strip of `triangles` triangles, bright, and a dim one far from it.
Scene strip_and_dim_lamp(int triangles) {
    Scene scene;
    std::vector<std::array<dvec3, 3>> strip;
    for (int i = 0; i < triangles; ++i) strip.push_back({dvec3(i, 0, 0), dvec3(i + 1, 0, 0), dvec3(i, 0, 1)});
    add_shape(scene, "strip", strip, {glm::vec3(0.0F), glm::vec3(50.0F), false});
    add_shape(scene, "dim", {{dvec3(0, 5, 0), dvec3(1, 5, 0), dvec3(0, 5, 1)}}, {glm::vec3(0.0F), glm::vec3(1.0F), false});
    look_at(scene, {0, 2, -5}, {0, 2, 0}, {0, 1, 0}, 60.0, 8, 8);
    return scene;
}

/// Different positions among those of `turns` sets of `count` samples, and of the last shape alone.
std::pair<std::size_t, std::size_t> distinct(const Scene& scene, int count, int turns) {
    const std::vector<LightForm> forms = choose_light_forms(scene, true, false);
    const FlatScene flat = flatten(scene, forms, 0, 0);
    std::set<std::array<float, 3>> all, last;
    for (int turn = 0; turn < turns; ++turn) {
        const std::vector<LightSample> samples = sample_lights(scene, flat, forms, count, 11, static_cast<std::uint64_t>(turn));
        for (const LightSample& s : samples) all.insert({s.position.x, s.position.y, s.position.z});
        last.insert({samples.back().position.x, samples.back().position.y, samples.back().position.z});
    }
    return {all.size(), last.size()};
}

TEST(LightSamples, TurnsDoNotRepeatThemselves) {
    constexpr int turns = 24;
    for (const int triangles : {1, 2, 2000})
        for (const int count : {8, 32, 34, 55, 89}) {  // Fibonacci numbers among them: golden steps nearly return
            const Scene scene = strip_and_dim_lamp(triangles);
            const auto [all, last] = distinct(scene, count, turns);
            SCOPED_TRACE(std::to_string(triangles) + " triangles, " + std::to_string(count) + " samples");
            EXPECT_GE(all, static_cast<std::size_t>(0.98 * count * turns));
            EXPECT_EQ(last, static_cast<std::size_t>(turns)) << "a lamp with less than one sample a turn";
        }
}

/// Mean square error of the mean of x^2 z over the unit square, by `turns` sets of samples of a lamp of two triangles.
double square_error(int turns, bool continued) {
    Scene scene;
    add_shape(scene, "lamp", {{dvec3(0, 0, 0), dvec3(1, 0, 0), dvec3(1, 0, 1)}, {dvec3(0, 0, 0), dvec3(1, 0, 1), dvec3(0, 0, 1)}},
              {glm::vec3(0.0F), glm::vec3(1.0F), false});
    look_at(scene, {0, 2, -5}, {0, 2, 0}, {0, 1, 0}, 60.0, 8, 8);
    const std::vector<LightForm> forms = choose_light_forms(scene, true, false);
    const FlatScene flat = flatten(scene, forms, 0, 0);
    double error = 0;
    constexpr int trials = 60;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        double sum = 0;
        std::size_t count = 0;
        for (std::uint64_t turn = 0; turn < static_cast<std::uint64_t>(turns); ++turn) {
            const std::uint64_t seed = continued ? trial : trial * 1000 + turn;
            for (const LightSample& s : sample_lights(scene, flat, forms, 12, seed, continued ? turn : 0)) {
                const dvec3 p = flat.normalisation.to_world(dvec3(s.position));
                sum += p.x * p.x * p.z;
                ++count;
            }
        }
        const double mean = sum / static_cast<double>(count) - 1.0 / 6.0;
        error += mean * mean / trials;
    }
    return error;
}

TEST(LightSamples, TurnsAreBetterThanSeeds) {
    const double seeds = square_error(16, false), turns = square_error(16, true);
    std::printf("mean square error of 16 sets: seeds %.2e, turns %.2e\n", seeds, turns);
    EXPECT_LT(turns, 0.25 * seeds);
}

/// A lamp of two quads that face away from each other: with a receiver below, most samples lie on the lower one, and the light that they
/// stand for is still that of both.
TEST(LightSamples, GoWhereTheyLightTheReceivers) {
    Scene scene;
    Surface lamp;
    lamp.radiance = glm::vec3(1.0F);
    std::vector<Face> faces;
    const glm::dvec3 corners[4] = {{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}};
    for (const double height : {0.0, 0.1}) {
        const glm::dvec3 up(0, height, 0);
        const auto corner = [&](int k) { return corners[k] + up; };
        if (height > 0) {
            faces.push_back({corner(0), corner(3), corner(2)});
            faces.push_back({corner(0), corner(2), corner(1)});
        } else {
            faces.push_back({corner(0), corner(1), corner(2)});
            faces.push_back({corner(0), corner(2), corner(3)});
        }
    }
    add_shape(scene, "lamp", faces, lamp);
    look_at(scene, {0.5, 0, 0.5}, {0.5, 1, 0.5}, {0, 0, 1}, 60.0, 4, 4);
    const std::vector<LightForm> forms(1, LightForm::samples);
    const FlatScene flat = flatten(scene, forms, 4, 4);
    const LightReceiver below{glm::vec3(flat.normalisation.to_scene({0.5, 0, 0.5})), glm::vec3(0, 1, 0)};
    const std::vector<float> importance = light_importance(scene, flat, forms, {below});
    int low = 0, all = 0;
    double power = 0;
    for (std::uint64_t turn = 0; turn < 16; ++turn)
        for (const LightSample& s : sample_lights(scene, flat, forms, 30, 7, turn, importance)) {
            low += s.normal.y < 0 ? 1 : 0;
            ++all;
            power += static_cast<double>(s.emission.x);
        }
    EXPECT_NEAR(static_cast<double>(low) / all, 0.925, 0.03) << "half of the share that goes by area lies above";
    const double scale = flat.normalisation.scale;
    EXPECT_NEAR(power / 16, 2.0 / (scale * scale), 0.15);
}

/// Texels consider whole threes of samples: on a round lamp these are not three times the same place.
TEST(LightSamples, ThreesOfARoundLampLieApart) {
    constexpr int around = 32, rings = 16, count = 96;
    const auto at = [](int i, int j) {
        const double phi = 2 * pi * i / around, theta = pi * j / rings;
        return glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    };
    std::vector<Face> faces;
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < around; ++i) {
            if (j > 0) faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            if (j + 1 < rings) faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    Scene scene;
    add_shape(scene, "lamp", faces, {glm::vec3(0.0F), glm::vec3(1.0F), false});
    look_at(scene, {0, 2, -5}, {0, 2, 0}, {0, 1, 0}, 60.0, 8, 8);
    const std::vector<LightForm> forms = choose_light_forms(scene, true, false);
    const FlatScene flat = flatten(scene, forms, 0, 0);
    const std::vector<LightSample> samples = sample_lights(scene, flat, forms, count, 3);
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(count));
    double nearest = 0;
    for (std::size_t k = 0; k < samples.size(); k += 3) {
        const auto place = [&](std::size_t m) { return flat.normalisation.to_world(glm::dvec3(samples[k + m].position)); };
        nearest += std::min({glm::distance(place(0), place(1)), glm::distance(place(1), place(2)), glm::distance(place(2), place(0))});
    }
    EXPECT_GT(nearest / (count / 3.0), 0.5) << "radii of the lamp";
}

TEST(PointThinner, KeepsSpacingsAndCovers) {
    constexpr float spacing = 0.1F, alike = 0.7F;
    PointThinner thinner(spacing, alike);
    struct Kept {
        glm::vec3 p, n;
        float spacing;
    };
    std::vector<Kept> kept;
    int refused = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const glm::vec3 p(2.0 * random_unit(1, 0, i) - 1.0, 2.0 * random_unit(1, 1, i) - 1.0, i % 2 == 0 ? 0.0 : 0.01);
        const glm::vec3 n(0, 0, i % 2 == 0 ? 1 : -1);
        const float own = p.x > 0 ? spacing : 0.5F * spacing;
        const bool near =
            std::any_of(kept.begin(), kept.end(), [&](const Kept& k) { return glm::distance(k.p, p) < own && glm::dot(k.n, n) > alike; });
        ASSERT_EQ(thinner.add(p, n, own), !near) << "point " << i;
        if (near)
            ++refused;
        else
            kept.push_back({p, n, own});
    }
    EXPECT_GT(kept.size(), 500U);
    EXPECT_GT(refused, 10000);
}

}  // namespace
