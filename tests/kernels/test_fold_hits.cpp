// Gutters of the geometry maps repeat the texel they fold to, and the plane atlas names the plane of every texel's triangle.
#include "kernels/kernel_test.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(FoldHits, GutterAndPlanes) {
    const TestScene scene = room_scene(31, 20);
    Random random(32);
    for (const int n : {2, 6, 16, 34}) {
        for (const int tiles : {1, 5}) {
            Kernels kernels = make_kernels();
            const DeviceScene on_device(device(), scene.flat);
            const GeometryMaps maps = rasterized(kernels, on_device, random_centres(random, tiles), n);
            const std::vector<Hit> hits = maps.hits.read();
            const std::vector<int> planes = maps.plane_atlas.read();
            for (int tile = 0; tile < tiles; ++tile) {
                for (int y = -1; y <= n; ++y) {
                    for (int x = -1; x <= n; ++x) {
                        const ref::Texel t = ref::fold(x, y, n);
                        const std::size_t at = atlas_index(tile, x, y, n);
                        const Hit got = hits[at], source = hits[atlas_index(tile, t.x, t.y, n)];
                        ASSERT_EQ(got.triangle, source.triangle) << "n " << n << " tile " << tile << " texel " << x << " " << y;
                        ASSERT_EQ(got.disparity, source.disparity) << "n " << n << " tile " << tile << " texel " << x << " " << y;
                        const int plane = got.triangle < 0 ? -1 : scene.triangles[static_cast<std::size_t>(got.triangle)].plane;
                        ASSERT_EQ(planes[at], plane) << "n " << n << " tile " << tile << " texel " << x << " " << y;
                    }
                }
            }
        }
    }
}

TEST(FoldHits, NothingSeenIsPlaneMinusOne) {
    const TestScene scene = soup_scene(33, 1);
    Kernels kernels = make_kernels();
    const DeviceScene on_device(device(), scene.flat);
    const GeometryMaps maps = rasterized(kernels, on_device, {to_float4(dvec3(0.99, 0.99, -0.99))}, 16);
    int empty = 0;
    for (const int plane : maps.plane_atlas.read()) empty += plane == -1 ? 1 : 0;
    EXPECT_GT(empty, 200);
}

}  // namespace
