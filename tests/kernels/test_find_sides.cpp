// Which sides of shapes a centre sees, against the hits of its map: fronts, and backs of two-sided materials only.
#include <set>

#include "kernels/kernel_test.h"
#include "line/find_sides.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(FindSides, AgainstHits) {
    for (const int materials : {1, 5, 40}) {  // one word, one word, three words
        TestScene scene = soup_scene(161, 200, materials);
        Random random(162);
        const std::vector<float4> centres = random_centres(random, 33);
        Kernels kernels = make_kernels();
        const DeviceScene on_device(device(), scene.flat);
        const std::size_t words = side_words(static_cast<std::size_t>(materials));
        for (const int n : {8, 24}) {
            const GeometryMaps maps = rasterized(kernels, on_device, centres, n);
            const std::vector<Hit> hits = maps.hits.read();
            const std::vector<uint> sides = find_sides(kernels, on_device, maps);
            ASSERT_EQ(sides.size(), words * centres.size());
            std::size_t fronts = 0, backs = 0, left_out = 0;
            for (int tile = 0; tile < maps.count; ++tile) {
                const dvec3 c = xyz(centres[static_cast<std::size_t>(tile)]);
                std::set<int> expected;
                for (int i = 0; i < n * n; ++i) {
                    const Hit hit = hits[atlas_index(tile, i % n, i / n, n)];
                    if (hit.triangle < 0) continue;
                    const ref::Triangle& t = scene.triangles[static_cast<std::size_t>(hit.triangle)];
                    const Triangle& flat = scene.flat.triangles[static_cast<std::size_t>(hit.triangle)];
                    const int shape = flat.shape;
                    const bool back = glm::dot(glm::cross(t.v1 - t.v0, t.v2 - t.v0), c - t.v0) < 0.0;
                    const bool counts = !back || scene.flat.materials[static_cast<std::size_t>(flat.material)].albedo.w != 0.0F;
                    ++(counts ? back ? backs : fronts : left_out);
                    if (counts) expected.insert(2 * shape + (back ? 1 : 0));
                }
                for (int side = 0; side < static_cast<int>(32 * words); ++side) {
                    const uint word = sides[static_cast<std::size_t>(tile) * words + static_cast<std::size_t>(side / 32)];
                    ASSERT_EQ((word >> (side % 32) & 1U) == 1U, expected.count(side) == 1)
                        << materials << " shapes, n " << n << ", tile " << tile << ", side " << side;
                }
            }
            EXPECT_GT(fronts, 100U);
            EXPECT_GT(backs + left_out, 100U);
        }
    }
}

}  // namespace
