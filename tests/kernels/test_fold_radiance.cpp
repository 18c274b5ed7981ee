// Radiance maps: what leaves a surfel arrives in the opposite texel (thesis eq. 5.7, E after Q), the density weight stays, gutters fold.
#include "kernels/kernel_test.h"
#include "transport/store_radiance.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(FoldRadiance, OppositeTexelWeightAndGutter) {
    Random random(51);
    for (const int n : {2, 4, 6, 16, 34}) {
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
            for (int y = -1; y <= n; ++y) {
                for (int x = -1; x <= n; ++x) {
                    const std::size_t at = atlas_index(tile, x, y, n);
                    SCOPED_TRACE("n " + std::to_string(n) + " tile " + std::to_string(tile) + " texel " + std::to_string(x) + " " +
                                 std::to_string(y));
                    if (tile < first || tile >= first + count) {
                        ASSERT_EQ(after[at], before[at]) << "a tile outside the range changed";
                        continue;
                    }
                    const ref::Texel t = ref::fold(x, y, n), seen = ref::antipodal_texel(t.x, t.y, n);
                    const int surfel = (tile - first) * n * n + seen.y * n + seen.x;
                    ASSERT_EQ(xyz(after[at]), rgb_at(values, static_cast<std::size_t>(surfels.capacity), surfel));
                    ASSERT_EQ(after[at].w, before[atlas_index(tile, t.x, t.y, n)].w) << "density weight";
                }
            }
        }
    }
}

}  // namespace
