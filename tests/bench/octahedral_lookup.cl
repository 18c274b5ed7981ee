// The octahedral look-up alone: direction, footprint, bilinear texel. Written as project_pencils does it, without visibility and weights.

#include "lib/footprint.cl"
#include "lib/octahedral.cl"
#include "lib/packet.cl"

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH points
/// in     : x, y, z [count]; cops[tile_count]; radiance: tiles of n x n
/// out    : sum[count]: sum over the tiles of the texel in direction x - cop
kernel void octahedral_lookup(global const float *x, global const float *y, global const float *z, int count, global const float4 *cops,
                              int tile_count, int n, global const float4 *radiance, global float4 *sum) {
    int first = get_global_id(0) * PENCIL_BLOCK * PENCIL_WIDTH;
    if (first >= count) return;
    float4 sums[PENCIL_BLOCK][PENCIL_WIDTH];
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        for (int l = 0; l < PENCIL_WIDTH; ++l) sums[p][l] = (float4)(0.0f);
    int stride = PENCIL_TILE_STRIDE(n);
    for (int i = 0; i < tile_count; ++i) {
        global const float4 *tile = radiance + (size_t)i * PENCIL_TILE_TEXELS(n);
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            int at = first + p * PENCIL_WIDTH;
            Footprint f =
                packet_footprint(PACKET_LOAD(x + at) - cops[i].x, PACKET_LOAD(y + at) - cops[i].y, PACKET_LOAD(z + at) - cops[i].z, n);
#pragma unroll
            for (int l = 0; l < PENCIL_WIDTH; ++l) {
                global const float4 *t = tile + ((const int *)&f.index)[l];
                float fx = ((const float *)&f.fx)[l], fy = ((const float *)&f.fy)[l];
                float4 upper = t[0] + fx * (t[1] - t[0]);
                float4 lower = t[stride] + fx * (t[stride + 1] - t[stride]);
                sums[p][l] += upper + fy * (lower - upper);
            }
        }
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        for (int l = 0; l < PENCIL_WIDTH; ++l) sum[first + p * PENCIL_WIDTH + l] = sums[p][l];
}
