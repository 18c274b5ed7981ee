// Pencil transport and projection-scatter. A block of surfels runs through the pencils one by one, so that a tile's texels are in the
// nearest cache. Directions, footprints and visibility are vectors of surfels; what is seen is packed into a list, and its texels are then
// fetched in one loop without branches.
#include "bench/native/native.h"
#include "bench/native/parallel.h"
#include "bench/native/visibility.h"

namespace pencil::native {
namespace {

constexpr int block_lanes = 128;

struct Sums {
    float4v light[block_lanes];  // rgb: sum of L cos/D; w: sum of cos/D
    int seen[block_lanes];
};

/// Adds one texel with weight cosine / D.
inline void add_texel(float4v texel, float cosine, float4v& light) {
    const float4v weight = cosine * __builtin_shufflevector(texel, texel, 3, 3, 3, 3);
    light += weight * __builtin_shufflevector(texel, float4v{1, 1, 1, 1}, 0, 1, 2, 7);
}

/// What a block sees of one tile.
struct SeenList {
    alignas(64) int surfel[block_lanes + lane_count], index[block_lanes + lane_count];
    alignas(64) float fx[block_lanes + lane_count], fy[block_lanes + lane_count], cosine[block_lanes + lane_count];
    int count = 0;
};

/// Directions and footprints of one vector of surfels; asks for the memory that they need next.
inline void aim(const SurfelVectors& s, const TileView& tile, const float4* texels, Aimed& out) {
    const vfloat vx = s.x - tile.cop[0], vy = s.y - tile.cop[1], vz = s.z - tile.cop[2];
    const vfloat towards = -(s.nx * vx + s.ny * vy + s.nz * vz);
    out.faces = lane_mask(towards > 0.0F);
    if (out.faces == 0) return;
    aim_at(tile, vx, vy, vz, out);
    out.weight = towards * reciprocal_sqrt(vx * vx + vy * vy + vz * vz);
    for (int l = 0; l < lane_count; l += 2) {
        __builtin_prefetch(texels + out.index[l]);
        __builtin_prefetch(texels + out.index[l] + PENCIL_TILE_STRIDE(tile.n));
    }
}

/// Appends what one vector of surfels, the first of them number `first` of the block, sees.
inline void look(const SurfelVectors& s, const TileView& tile, const Aimed& aimed, int first, SeenList& list) {
    const unsigned visible = visible_lanes(s, tile, aimed);
    store_packed(lane_numbers() + first, visible, list.surfel + list.count);
    store_packed(aimed.f.index, visible, list.index + list.count);
    store_packed(aimed.f.fx, visible, list.fx + list.count);
    store_packed(aimed.f.fy, visible, list.fy + list.count);
    store_packed(aimed.weight, visible, list.cosine + list.count);
    list.count += __builtin_popcount(visible);
}

/// Adds one pencil to the sums of a block.
inline void project(const SurfelVectors* packets, const TileView& tile, const float4* texels, Sums& sums) {
    Aimed aimed[block_lanes / lane_count];
    SeenList list;
    for (int p = 0; p < block_lanes / lane_count; ++p) aim(packets[p], tile, texels, aimed[p]);
    for (int p = 0; p < block_lanes / lane_count; ++p) look(packets[p], tile, aimed[p], p * lane_count, list);
    const int stride = PENCIL_TILE_STRIDE(tile.n);
    for (int k = 0; k < list.count; ++k) {
        add_texel(fetch(texels + list.index[k], stride, list.fx[k], list.fy[k]), list.cosine[k], sums.light[list.surfel[k]]);
        ++sums.seen[list.surfel[k]];
    }
}

void finish(const SurfelsView& surfels, const Sums& sums, int first, int last, RgbView outgoing, int* visible) {
    for (int i = first; i < last; ++i) {
        const float4v light = sums.light[i - first];
        const float factor = light[3] > 0.0F ? 1.0F / light[3] : 0.0F;  // pi of the weights and 1/pi of the BRDF cancel
        for (int c = 0; c < 3; ++c) outgoing.channel(c)[i] += surfels.field(SURFEL_ALBEDO_R + c)[i] * light[c] * factor;
        visible[i] = sums.seen[i - first];
    }
}

}  // namespace

void project_pencils(const SceneView& scene, const SurfelsView& surfels, const MapsView& maps, const float4* radiance, RgbView outgoing,
                     int* visible) {
    parallel_blocks(
        surfels.count, block_lanes,
        [&](int first, int last) {
            SurfelVectors s[block_lanes / lane_count];
            for (int p = 0; p < block_lanes / lane_count; ++p) s[p] = load_surfels(surfels, first + p * lane_count);
            alignas(64) Sums sums{};
            for (int i = 0; i < maps.count; ++i) {
                const TileView tile(scene, maps, i);
                const float4* texels = radiance + static_cast<std::size_t>(i) * maps.tile_texels();
                project(s, tile, texels, sums);
            }
            finish(surfels, sums, first, last, outgoing, visible);
        });
}

}  // namespace pencil::native
