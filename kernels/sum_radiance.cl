// Mean radiance of pencil maps: tells how much light is still under way, so that bounces can stop.

#include "lib/map.cl"

/// launch : 1-D, one work-item per tile; the sum runs in a fixed order
/// in     : radiance, atlas layout, interior texels
/// out    : means[tile]: rgb mean over the texels
kernel void sum_radiance(global const float4 *radiance, int tile_count, int n, global float4 *means) {
    int tile = get_global_id(0);
    if (tile >= tile_count) return;
    float4 sum = (float4)(0.0f);
    for (int y = 0; y < MAP_PANELS * n; ++y) {
        float4 row = (float4)(0.0f);
        for (int x = 0; x < n; ++x) row += radiance[map_atlas_index(tile, map_texel_of_row(x, y, n), n)];
        sum += row;
    }
    means[tile] = sum / (float)MAP_TEXELS(n);
}
