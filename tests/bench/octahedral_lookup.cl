// The octahedral look-up alone: direction, footprint, bilinear texel of the buffer or the image, as in project_pencils, without visibility and
// weights.

#include "lib/atlas.cl"
#include "lib/footprint.cl"
#include "lib/packet.cl"

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH points
/// in     : x, y, z [count]; cops[tile_count]; radiance: an atlas of n x n tiles
/// out    : sum[count]: sum over the tiles of the texel in direction x - cop
kernel void octahedral_lookup(global const float *x, global const float *y, global const float *z, int count, global const float4 *cops,
                              int tile_count, int n, RADIANCE_ATLAS radiance, global float4 *sum) {
    int first = get_global_id(0) * PENCIL_BLOCK * PENCIL_WIDTH;
    if (first >= count) return;
    float4 sums[PENCIL_BLOCK][PENCIL_WIDTH];
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        for (int l = 0; l < PENCIL_WIDTH; ++l) sums[p][l] = (float4)(0.0f);
    for (int i = 0; i < tile_count; ++i) {
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            int at = first + p * PENCIL_WIDTH;
            Footprint f =
                map_footprint_in(i, PACKET_LOAD(x + at) - cops[i].x, PACKET_LOAD(y + at) - cops[i].y, PACKET_LOAD(z + at) - cops[i].z, n);
#pragma unroll
            for (int l = 0; l < PENCIL_WIDTH; ++l) sums[p][l] += fetch_radiance(radiance, i, &f, l, PENCIL_TILE_STRIDE(n));
        }
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        for (int l = 0; l < PENCIL_WIDTH; ++l) sum[first + p * PENCIL_WIDTH + l] = sums[p][l];
}
