// Radiance maps: what leaves a surfel arrives in the opposite texel (thesis eq. 5.7, E after Q), smoothed over a texel by the binomial mean
// (1 2 1)^2 / 16 of folded neighbours; the density weight stays, gutters repeat what they fold to. Covers store_radiance, too.
#include <algorithm>

#include "kernels/kernel_test.h"
#include "line/store_radiance.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// Radiance of the texel that lies opposite the one that sees surfel i, before smoothing, row by row.
std::vector<dvec3> sharp_tile(const std::vector<float>& outgoing, std::size_t capacity, int first_surfel, int n) {
    std::vector<dvec3> out(static_cast<std::size_t>(n * n), dvec3(-1.0));
    for (int i = 0; i < n * n; ++i) {
        const ref::Texel seen = surfel_texel(i, n), opposite = ref::antipodal_texel(seen.x, seen.y, n);
        out[static_cast<std::size_t>(opposite.y * n + opposite.x)] = rgb_at(outgoing, capacity, first_surfel + i);
    }
    EXPECT_EQ(std::count(out.begin(), out.end(), dvec3(-1.0)), 0) << "surfels and texels are one to one";
    return out;
}

dvec3 smoothed(const std::vector<dvec3>& sharp, int x, int y, int n) {
    dvec3 sum(0.0);
    for (int k = 0; k < 9; ++k) {
        const int dx = k % 3 - 1, dy = k / 3 - 1;
        const ref::Texel t = ref::fold(x + dx, y + dy, n);
        sum += (dx == 0 ? 2.0 : 1.0) * (dy == 0 ? 2.0 : 1.0) / 16.0 * sharp[static_cast<std::size_t>(t.y * n + t.x)];
    }
    return sum;
}

TEST(SmoothRadiance, OppositeTexelSmoothedWeightKeptGutterFolded) {
    Random random(51);
    for (const int n : {8, 16, 24, 64}) {
        const int tiles = 4, first = 1, count = 2;
        Kernels kernels = make_kernels();
        PencilSet set(device(), std::make_shared<GeometryMaps>(device(), random_centres(random, tiles), n, "test"));
        std::vector<float4> before(set.radiance.size());
        for (float4& texel : before) texel = to_float4(random.in_box(0, 1), random.uniform());
        set.radiance.write(before);
        Surfels surfels(device(), count * n * n, "surfels");
        std::vector<float> values(static_cast<std::size_t>(surfels.capacity) * 3);
        for (float& value : values) value = static_cast<float>(random.uniform(0, 9));
        const Buffer<float> outgoing(device(), values, "outgoing");
        store_radiance(kernels, surfels, outgoing, first, count, set);
        const std::vector<float4> after = set.radiance.read();
        for (int tile = 0; tile < tiles; ++tile) {
            const bool stored = tile >= first && tile < first + count;
            std::vector<dvec3> sharp;
            if (stored) sharp = sharp_tile(values, static_cast<std::size_t>(surfels.capacity), (tile - first) * n * n, n);
            for (int y = -1; y <= n; ++y) {
                for (int x = -1; x <= n; ++x) {
                    const std::size_t at = atlas_index(tile, x, y, n);
                    SCOPED_TRACE("n " + std::to_string(n) + " tile " + std::to_string(tile) + " texel " + std::to_string(x) + " " +
                                 std::to_string(y));
                    if (!stored) {
                        ASSERT_EQ(after[at], before[at]) << "a tile outside the range changed";
                        continue;
                    }
                    const ref::Texel t = ref::fold(x, y, n);
                    expect_close(xyz(after[at]), smoothed(sharp, t.x, t.y, n), 1e-6, "radiance");
                    ASSERT_EQ(after[at].w, before[atlas_index(tile, t.x, t.y, n)].w) << "density weight";
                    if (testing::Test::HasFatalFailure()) return;
                }
            }
        }
    }
}

}  // namespace
