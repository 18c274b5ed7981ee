// Completes radiance maps: smooths over a texel and fills the gutters by folding, so that bilinear look-ups are seamless.

#include "lib/map.cl"
#include "shared/atlas.h"
#include "shared/weights.h"

/// Sum of the weights (1 2 1)^2.
#define BINOMIAL_SUM 16.0f

/// launch : 1-D, one work-item per texel of `tile_count` tiles, gutters included
/// in     : sharp, atlas layout, interior texels of tiles 0 .. tile_count
/// out    : radiance, atlas layout, tiles first_tile ..: rgb is the binomial mean (1 2 1)^2 of the sharp texels around; w is kept
/// PENCIL_WEIGHTS_POWER: nothing is smoothed, for rays look up single texels, and lines beside an edge would take light of the other side.
/// DEVIATION: the thesis looks up what was rendered. A texel is one sample of its surface, so edges in the map are staircases; the mean
/// turns them into ramps of the width that bilinear look-ups resolve anyway.
kernel void smooth_radiance(global const float4 *sharp, int first_tile, int tile_count, int n, global float4 *radiance) {
    int item = get_global_id(0);
    int texels = MAP_STORED(n);
    if (item >= tile_count * texels) return;
    int stride = PENCIL_TILE_STRIDE(n);
    int tile = item / texels;
    int2 centre = map_texel_beside((int2)(item % texels % stride, item % texels / stride) - PENCIL_GUTTER, (int2)(0), n);
    int at = map_atlas_index(tile, centre, n);
    if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER) {
        radiance[(size_t)first_tile * texels + item] = sharp[at];
        return;
    }
    bool inside = map_is_inner(centre, n);  // no neighbour to be folded
    float3 sum = (float3)(0.0f);
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
            int from = inside ? at + dy * stride + dx : map_atlas_index(tile, map_texel_beside(centre, (int2)(dx, dy), n), n);
            sum += (float)((2 - abs(dx)) * (2 - abs(dy))) * sharp[from].xyz;
        }
    radiance[(size_t)first_tile * texels + item] = (float4)(sum / BINOMIAL_SUM, sharp[at].w);
}
