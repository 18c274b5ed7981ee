// Gutters of the geometry maps repeat the texel they fold to. Cells name, for the footprint that starts at a texel, the planes that its
// four texels show, or say that the footprint cannot speak for a plane.
#include "kernels/kernel_test.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(FoldHits, GutterAndCells) {
    const TestScene scene = room_scene(31, 20);
    Random random(32);
    int mixed = 0, pure = 0;
    for (const int n : {2, 6, 16, 34}) {
        for (const int tiles : {1, 5}) {
            SCOPED_TRACE("n " + std::to_string(n));
            Kernels kernels = make_kernels();
            const DeviceScene on_device(device(), scene.flat);
            const GeometryMaps maps = rasterized(kernels, on_device, random_centres(random, tiles), n);
            const std::vector<Hit> hits = maps.hits.read();
            const std::vector<glm::ivec4> cells = maps.cells.read();
            for (int tile = 0; tile < tiles; ++tile) {
                const auto plane = [&](int x, int y) {
                    const ref::Texel t = ref::fold(x, y, n);
                    const int triangle = hits[atlas_index(tile, t.x, t.y, n)].triangle;
                    return triangle < 0 ? -1 : scene.triangles[static_cast<std::size_t>(triangle)].plane;
                };
                for (int y = -1; y <= n; ++y) {
                    for (int x = -1; x <= n; ++x) {
                        SCOPED_TRACE("tile " + std::to_string(tile) + " texel " + std::to_string(x) + " " + std::to_string(y));
                        const ref::Texel t = ref::fold(x, y, n);
                        const Hit got = hits[atlas_index(tile, x, y, n)], source = hits[atlas_index(tile, t.x, t.y, n)];
                        ASSERT_EQ(got.triangle, source.triangle);
                        ASSERT_EQ(got.disparity, source.disparity);
                        if (x == n || y == n) continue;  // no footprint starts in the last gutter
                        const glm::ivec4 cell = cells[atlas_index(tile, x, y, n)],
                                         shown(plane(x, y), plane(x + 1, y), plane(x, y + 1), plane(x + 1, y + 1));
                        const bool one_plane = shown == glm::ivec4(shown.x);
                        for (int k = 0; k < 4; ++k) {
                            const bool is_mixed = cell[k] == CELL_MIXED;
                            ASSERT_TRUE(cell[k] == shown[k] || (is_mixed && !one_plane))
                                << "texel " << k << " shows " << shown[k] << ", cell " << cell[k];
                            (is_mixed ? mixed : pure) += 1;
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(mixed, 100);
    EXPECT_GT(pure, 1000);
}

TEST(FoldHits, NothingSeenIsMinusOne) {
    const TestScene scene = soup_scene(33, 1);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    const GeometryMaps maps = rasterized(kernels, on_device, {to_float4(dvec3(0.99, 0.99, -0.99))}, 16);
    int empty = 0;
    for (const glm::ivec4& cell : maps.cells.read()) empty += cell == glm::ivec4(-1) ? 1 : 0;
    EXPECT_GT(empty, 150);
}

}  // namespace
