// Gutters of the geometry maps repeat the texel they fold to. Cells name, for the footprint that starts at a texel, the planes that its
// four texels show, or say that the footprint cannot speak for a plane.
#include <algorithm>
#include <array>
#include <set>

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
            const std::vector<glm::ivec2> cells = maps.cells.read();
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
                        const glm::ivec2 cell = cells[atlas_index(tile, x, y, n)];
                        const std::array<int, 4> shown{plane(x, y), plane(x + 1, y), plane(x, y + 1), plane(x + 1, y + 1)};
                        const bool one_plane = std::count(shown.begin(), shown.end(), shown[0]) == 4;
                        ASSERT_TRUE(!one_plane || cell == glm::ivec2(shown[0]))
                            << "plane " << shown[0] << " fills the footprint, cell " << cell.x << " " << cell.y;
                        // shared/atlas.h: the second entry may stand for the plane that can hide surfels on the first.
                        const int second = cell.y <= CELL_PAIR(0) ? CELL_PAIR(cell.y) : cell.y;
                        for (const int named : {cell.x, second}) {
                            const bool is_shown = std::count(shown.begin(), shown.end(), named) > 0;
                            ASSERT_TRUE(is_shown || named == CELL_MIXED) << "cell names " << named << ", which no texel shows";
                            (named == CELL_MIXED ? mixed : pure) += 1;
                        }
                        ASSERT_TRUE(one_plane || cell.x != cell.y || cell.x == CELL_MIXED) << "not filled by plane " << cell.x;
                        const std::set<int> planes(shown.begin(), shown.end());
                        ASSERT_TRUE(cell.x == CELL_MIXED || one_plane || planes == (std::set<int>{cell.x, second}))
                            << "a cell that settles visibility names all that it shows";
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
    for (const glm::ivec2& cell : maps.cells.read()) empty += cell == glm::ivec2(-1) ? 1 : 0;
    EXPECT_GT(empty, 150);
}

}  // namespace
