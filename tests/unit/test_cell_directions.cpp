// The directions that sample Voronoi cells, and the cells' reference.
#include <gtest/gtest.h>

#include "pencils/cell_directions.h"
#include "reference/random.h"
#include "reference/voronoi_ref.h"
#include "shared/weights.h"

namespace {

using namespace pencil;
using ref::dvec3;

std::vector<dvec3> split(int grid, std::vector<float4>& axes) {
    const std::vector<float4> table = cell_directions(grid);
    const std::size_t tiles = static_cast<std::size_t>(grid * grid / PENCIL_CELL_TILE);
    axes.assign(table.begin(), table.begin() + static_cast<std::ptrdiff_t>(tiles));
    std::vector<dvec3> out;
    for (std::size_t i = tiles; i < table.size(); ++i) out.emplace_back(table[i].x, table[i].y, table[i].z);
    return out;
}

TEST(CellDirections, FollowTheCosine) {
    for (const int grid : {8, 24, 48}) {
        std::vector<float4> axes;
        const std::vector<dvec3> directions = split(grid, axes);
        ASSERT_EQ(directions.size(), static_cast<std::size_t>(grid * grid));
        dvec3 mean(0.0);
        double square = 0.0;
        for (const dvec3& d : directions) {
            ASSERT_NEAR(glm::length(d), 1.0, 1e-6);
            ASSERT_GT(d.z, 0.0);
            mean += d / static_cast<double>(directions.size());
            square += d.z * d.z / static_cast<double>(directions.size());
        }
        EXPECT_NEAR(mean.x, 0.0, 1e-6);
        EXPECT_NEAR(mean.y, 0.0, 1e-6);
        EXPECT_NEAR(mean.z, 2.0 / 3.0, 0.2 / grid);
        EXPECT_NEAR(square, 0.5, 0.2 / grid);
    }
}

TEST(CellDirections, TilesLieWithinTheirAngle) {
    std::vector<float4> axes;
    const std::vector<dvec3> directions = split(24, axes);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const float4& axis = axes[i / PENCIL_CELL_TILE];
        const double cosine = glm::dot(directions[i], dvec3(axis.x, axis.y, axis.z));
        ASSERT_GE(2.0 * cosine * cosine - 1.0, axis.w - 1e-6) << i;
        ASSERT_GT(cosine, 0.7) << "neighbours";
    }
}

TEST(Voronoi, WeightsSumToPiAndTwoPencilsShareByTheirBisector) {
    ref::Random random(3);
    for (int trial = 0; trial < 20; ++trial) {
        const dvec3 normal = random.direction();
        std::vector<dvec3> directions;
        while (directions.size() < 2) {
            const dvec3 d = random.direction();
            if (glm::dot(d, normal) > 0.0) directions.push_back(d);
        }
        const std::vector<double> weights = ref::cell_weights(normal, directions, {true, true}, 20000);
        EXPECT_NEAR(weights[0] + weights[1], ref::pi, 1e-9);
        EXPECT_NEAR(weights[0], ref::first_of_two(normal, directions[0], directions[1]), 0.01);
        EXPECT_NEAR(ref::cell_weights(normal, directions, {true, false}, 100)[0], ref::pi, 1e-9) << "hidden ones have no cell";
    }
}

}  // namespace
