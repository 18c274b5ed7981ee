// Look-ups of radiance maps alone, through the accessors that projection uses.

#include "lib/atlas.cl"
#include "lib/footprint.cl"
#include "lib/packet.cl"

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH directions
/// in     : x, y, z [count], count a multiple of PENCIL_WIDTH; radiance: tiles of n x n
/// out    : filtered[count], texels[count]: in tile number i % tile_count of direction i, and the first texel of its footprint
kernel void look_up_atlas(global const float *x, global const float *y, global const float *z, int count, RADIANCE_ATLAS radiance,
                          int tile_count, int n, global float4 *filtered, global float4 *texels) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= count) return;
    Footprint f = map_footprint(PACKET_LOAD(x + first), PACKET_LOAD(y + first), PACKET_LOAD(z + first), n);
    vint index = f.index;
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int tile = (first + l) % tile_count;
        f.index = index + tile * MAP_STORED(n);
        filtered[first + l] = fetch_radiance(radiance, tile, &f, l, PENCIL_TILE_STRIDE(n));
        texels[first + l] = radiance_texel(radiance, tile, footprint_corner(&f, l), n);
    }
}
