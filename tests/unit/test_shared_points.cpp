// Points that pencils of the world set gather from: importance is the adjoint of transport, draws follow it.
#include <gtest/gtest.h>

#include <cmath>

#include "surface/shared_points.h"

namespace {

using namespace pencil;

/// Two pencils of two texels each, and one seed of two texels. Every point reads one pencil, but for one that reads both.
struct System {
    std::vector<SeenPoints::Point> points;
    PointLinks links;

    System() {
        add(0, 1.0F, 0.5F);  // the film's
        add(1, 1.0F, 0.25F);
        add(1, 1.0F, 0.8F);  // of pencil 0
        both(0.6F, 0.5F);
        add(0, 1.0F, 0.4F);  // of pencil 1
        add(0, 1.0F, 0.0F);  // black
    }
    void add(int pencil, float weight, float albedo) {
        points.push_back({glm::vec3(static_cast<float>(points.size()), 1, 0), glm::vec3(0, 0, 1), albedo});
        links.pencils.emplace_back(pencil, -1, -1, -1);
        links.weights.emplace_back(weight, 0, 0, 0);
    }
    void both(float first, float albedo) {
        points.push_back({glm::vec3(static_cast<float>(points.size()), 1, 0), glm::vec3(0, 0, 1), albedo});
        links.pencils.emplace_back(0, 1, -1, -1);
        links.weights.emplace_back(first, 1 - first, 0, 0);
    }
};

TEST(SharedPoints, ImportanceIsTheAdjointSeries) {
    const System s;
    const std::vector<float> found = pencil_importance(s.points, s.links, 2, 1, 2);
    // W = g + T^T W: what the film reads, and what the texels of each pencil read, halved as there are two.
    const double g0 = 0.5, g1 = 0.25, t00 = 0.6 * 0.5 / 2, t01 = (0.8 + 0.4 * 0.5) / 2, t10 = 0.4 / 2, t11 = 0;
    const double determinant = (1 - t00) * (1 - t11) - t10 * t01;
    EXPECT_NEAR(found[0], (g0 * (1 - t11) + g1 * t10) / determinant, 0.01);
    EXPECT_NEAR(found[1], (g1 * (1 - t00) + g0 * t01) / determinant, 0.01);
}

TEST(SharedPoints, DrawsFollowWhatIsRead) {
    const System s;
    const SharedPoints shared(s.points, s.links, 2, 1, 2);
    const std::vector<float> w = pencil_importance(s.points, s.links, 2, 1, 2);
    // Of pencil 0: the film's first point, the shared one, the one of pencil 1.
    const double read[3] = {0.5, w[0] / 2.0 * 0.5 * 0.6, w[1] / 2.0 * 0.4}, total = read[0] + read[1] + read[2];
    std::vector<int> count(s.points.size(), 0);
    constexpr int runs = 4000, draws = 4;
    for (std::uint64_t seed = 0; seed < runs; ++seed)
        for (const int point : shared.draw(0, draws, seed)) ++count.at(static_cast<std::size_t>(point));
    EXPECT_NEAR(count[0], runs * draws * read[0] / total, 200);
    EXPECT_NEAR(count[3], runs * draws * read[1] / total, 200);
    EXPECT_NEAR(count[4], runs * draws * read[2] / total, 200);
    EXPECT_EQ(count[5], 0) << "what reflects nothing reads nothing";
}

TEST(SharedPoints, WhatNothingReadsDrawsNothing) {
    const SharedPoints none({}, {}, 1, 0, 4);
    EXPECT_EQ(none.draw(0, 2, 1), std::vector<int>({-1, -1}));
    EXPECT_EQ(none.draw(5, 2, 1), std::vector<int>({-1, -1})) << "no such pencil";
}

}  // namespace
