// Clusters hold every triangle once, and their boxes and those of groups hold them.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "pencils/cluster_triangles.h"
#include "reference/random.h"

namespace pencil {
namespace {

std::vector<Triangle> random_triangles(int count) {
    ref::Random random(static_cast<std::uint32_t>(count));
    std::vector<Triangle> out(static_cast<std::size_t>(count));
    for (Triangle& t : out) {
        const glm::dvec3 middle = random.in_box(-0.9, 0.9);
        const double size = std::pow(10.0, random.uniform(-4, -1));
        for (float4* corner : {&t.v0, &t.v1, &t.v2}) *corner = float4(glm::vec3(middle + size * random.direction()), 0.0F);
    }
    return out;
}

void expect_holds(const Cluster& box, const float4& p) {
    for (int axis = 0; axis < 3; ++axis) {
        ASSERT_LT(box.low[axis], p[axis]);
        ASSERT_GT(box.high[axis], p[axis]);
    }
}

TEST(ClusterTriangles, HoldEveryTriangleOnce) {
    for (const int count : {0, 1, 16, 17, 256, 257, 5000}) {
        const std::vector<Triangle> triangles = random_triangles(count);
        const Clusters clusters = cluster_triangles(triangles);
        ASSERT_EQ(clusters.count, (count + CLUSTER_TRIANGLES - 1) / CLUSTER_TRIANGLES);
        const int groups = (clusters.count + CLUSTER_GROUP - 1) / CLUSTER_GROUP;
        ASSERT_EQ(clusters.boxes.size(), static_cast<std::size_t>(clusters.count + groups));
        std::vector<int> sorted = clusters.members, all(static_cast<std::size_t>(count));
        std::sort(sorted.begin(), sorted.end());
        std::iota(all.begin(), all.end(), 0);
        EXPECT_EQ(sorted, all);
        for (int m = 0; m < count; ++m) {
            const int cluster = m / CLUSTER_TRIANGLES, group = clusters.count + cluster / CLUSTER_GROUP;
            const Triangle& t = triangles[static_cast<std::size_t>(clusters.members[static_cast<std::size_t>(m)])];
            for (const float4& corner : {t.v0, t.v1, t.v2}) {
                expect_holds(clusters.boxes[static_cast<std::size_t>(cluster)], corner);
                expect_holds(clusters.boxes[static_cast<std::size_t>(group)], corner);
            }
        }
    }
}

TEST(ClusterTriangles, AreSmall) {
    // Of triangles much smaller than the scene, clusters are too.
    std::vector<Triangle> triangles = random_triangles(20000);
    for (Triangle& t : triangles) t.v1 = t.v2 = t.v0 + 1e-3F;
    const Clusters clusters = cluster_triangles(triangles);
    double sum = 0;
    for (int c = 0; c < clusters.count; ++c) {
        const float4 extent = clusters.boxes[static_cast<std::size_t>(c)].high - clusters.boxes[static_cast<std::size_t>(c)].low;
        sum += static_cast<double>(std::max({extent.x, extent.y, extent.z}));
    }
    EXPECT_LT(sum / clusters.count, 0.4) << "of 1.8; about 0.17 for cubes of 16 triangles";
}

}  // namespace
}  // namespace pencil
