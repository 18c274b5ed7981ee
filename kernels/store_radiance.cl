// Completes the pencil transport operator: E o Q of thesis eq. (5.7). The radiance that leaves a surfel towards its centre of projection
// passes through it and travels on in the same direction, so it belongs to the antipode of the texel that sees the surfel.

#include "lib/map.cl"

/// launch : 1-D, one work-item per texel of `tile_count` tiles
/// in     : outgoing[3][capacity], surfel order of gather_surfels
/// out    : radiance, atlas layout, rgb of interior texels (w, the density weight, is left alone)
kernel void store_radiance(global const float *outgoing, int capacity, int first_tile, int tile_count, int n, global float4 *radiance) {
    int i = get_global_id(0);
    if (i >= tile_count * MAP_TEXELS(n)) return;
    int tile = first_tile + i / MAP_TEXELS(n);
    int2 texel = map_antipode(map_surfel_texel(i % MAP_TEXELS(n), n), n);
    int target = map_atlas_index(tile, texel, n);
    radiance[target].xyz = (float3)(outgoing[i], outgoing[(size_t)capacity + i], outgoing[2 * (size_t)capacity + i]);
}
