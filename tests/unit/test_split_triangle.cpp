// Triangles that are large beside their distance from the eye are split, without holes.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <tuple>

#include "scene/split_triangle.h"

namespace {

using namespace pencil;
using glm::dvec3;

double area(const std::array<dvec3, 3>& t) { return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); }

constexpr double near = 0.01, far = 1e6;
const dvec3 eye(0.3, 1.7, 0.2);

/// The two halves of a square ground of `extent` around the origin.
std::vector<std::vector<TrianglePiece>> ground(double extent) {
    const TriangleSplitter splitter(eye, near);
    const dvec3 a(-extent, 0, -extent), b(-extent, 0, extent), c(extent, 0, extent), d(extent, 0, -extent);
    return {splitter.split(a, b, c), splitter.split(a, c, d)};
}

TEST(SplitTriangle, OrdinaryOnesStayWhole) {
    for (const auto& pieces : ground(5)) {
        ASSERT_EQ(pieces.size(), 1U);
        EXPECT_EQ(pieces[0].weight[1], dvec3(0, 1, 0));
    }
}

TEST(SplitTriangle, PiecesFillTheTriangle) {
    for (const auto& pieces : ground(far)) {
        EXPECT_GT(pieces.size(), 10U);
        EXPECT_LT(pieces.size(), 1000U);
        double sum = 0;
        for (const TrianglePiece& p : pieces) {
            sum += area(p.corner);
            EXPECT_GT(glm::cross(p.corner[1] - p.corner[0], p.corner[2] - p.corner[0]).y, 0.0) << "faces the same way";
            for (const dvec3& w : p.weight) EXPECT_NEAR(w.x + w.y + w.z, 1.0, 1e-12);
        }
        EXPECT_NEAR(sum, 2 * far * far, 1e-6 * far * far);
    }
}

/// Every edge inside belongs to two pieces, of one triangle or of both.
TEST(SplitTriangle, NeighboursShareTheirEdges) {
    using Point = std::tuple<double, double, double>;
    const auto point = [](const dvec3& p) { return Point(p.x, p.y, p.z); };
    std::map<std::pair<Point, Point>, int> edges;
    for (const auto& pieces : ground(far))
        for (const TrianglePiece& p : pieces)
            for (std::size_t k = 0; k < 3; ++k) {
                const Point a = point(p.corner[k]), b = point(p.corner[(k + 1) % 3]);
                ++edges[std::minmax(a, b)];
            }
    const auto on_border = [](const Point& a, const Point& b) {
        return (std::get<0>(a) == std::get<0>(b) && std::abs(std::get<0>(a)) == far) ||
               (std::get<2>(a) == std::get<2>(b) && std::abs(std::get<2>(a)) == far);
    };
    for (const auto& [edge, count] : edges) EXPECT_EQ(count, on_border(edge.first, edge.second) ? 1 : 2);
}

TEST(SplitTriangle, EdgesAreShortWhereTheEyeIs) {
    for (const auto& pieces : ground(far))
        for (const TrianglePiece& p : pieces)
            for (std::size_t k = 0; k < 3; ++k) {
                const dvec3 a = p.corner[k], step = p.corner[(k + 1) % 3] - a;
                const double along = glm::clamp(glm::dot(eye - a, step) / glm::dot(step, step), 0.0, 1.0);
                EXPECT_LE(glm::length(step),
                          TriangleSplitter::most_length * std::max(glm::distance(a + along * step, eye), near) * (1 + 1e-9));
            }
}

/// An eye on the surface: nothing nearer than the near plane is seen, so there is an end.
TEST(SplitTriangle, EndsWhereTheEyeLiesOnIt) {
    const TriangleSplitter splitter(dvec3(0), near), none(dvec3(0), 0.0);
    EXPECT_LT(splitter.split({-far, 0, -far}, {0, 0, far}, {far, 0, -far}).size(), 2000U);
    EXPECT_LT(none.split({0, 0, 0}, {0, 0, far}, {far, 0, 0}).size(), 10000U);
}

}  // namespace
