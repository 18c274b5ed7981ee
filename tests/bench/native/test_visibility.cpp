#include "bench/native/native.h"
#include "bench/native/parallel.h"
#include "bench/native/visibility.h"

namespace pencil::native {
namespace {

constexpr int block_lanes = 128;

inline void aim(const SurfelVectors& s, const TileView& tile, Aimed& out) {
    const vfloat vx = s.x - tile.cop[0], vy = s.y - tile.cop[1], vz = s.z - tile.cop[2];
    out.faces = lane_mask(s.nx * vx + s.ny * vy + s.nz * vz < 0.0F);
    if (out.faces != 0) aim_at(tile, vx, vy, vz, out);
}

}  // namespace

void test_visibility(const SceneView& scene, const SurfelsView& surfels, const MapsView& maps, uint* mask) {
    parallel_blocks(
        surfels.count, block_lanes,
        [&](int first, int) {
            constexpr int packets = block_lanes / lane_count;
            SurfelVectors s[packets];
            for (int p = 0; p < packets; ++p) s[p] = load_surfels(surfels, first + p * lane_count);
            for (int word = 0; word * 32 < maps.count; ++word) {
                vint words[packets] = {};
                for (int i = 32 * word; i < std::min(32 * word + 32, maps.count); ++i) {
                    const TileView tile(scene, maps, i);
                    const int bit = static_cast<int>(1U << (i % 32));
                    Aimed aimed[packets];
                    for (int p = 0; p < packets; ++p) aim(s[p], tile, aimed[p]);
                    for (int p = 0; p < packets; ++p) words[p] |= lanes_of(visible_lanes(s[p], tile, aimed[p])) & bit;
                }
                for (int p = 0; p < packets; ++p)
                    store(words[p], mask + static_cast<std::size_t>(word) * surfels.capacity + first + p * lane_count);
            }
        });
}

}  // namespace pencil::native
