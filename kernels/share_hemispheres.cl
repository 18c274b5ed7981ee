// Beside guided rays (guide_hemispheres.cl) texels count by the share that the balance heuristic leaves them.

#include "lib/hemisphere_rays.cl"
#include "lib/spots.cl"

/// launch : 1-D, one work-item per pencil of first_pencil ..
/// in     : pencils; texels, n, seed, shift: as in trace_hemispheres; spots, weights: as in guide_hemispheres
/// in/out : radiance[3][capacity] that the texels send, `texels` entries per pencil: times their share
kernel void share_hemispheres(global const SurfacePencil *pencils, int first_pencil, int pencil_count, int texels, int n, uint seed,
                              uint2 shift, global const float4 *spots, global const float *weights, int spot_count, global float *radiance,
                              int capacity) {
    int item = get_global_id(0);
    if (item >= pencil_count) return;
    global const SurfacePencil *pencil = pencils + first_pencil + item;
    SpotView view = view_spots(pencil, spots, weights, spot_count);
    if (view.count == 0) return;
    for (int first = item * texels; first < (item + 1) * texels; first += PENCIL_WIDTH) {
        vfloat x, y, z;
        hemisphere_rays(pencil, first % (n * n), n, seed, shift, &x, &y, &z);
        vfloat guides = guides_density(&view, x, y, z);
        if (!PACKET_ANY(PACKET_MASK(guides > 0.0f))) continue;
        float3 normal = pencil->normal.xyz;
        vfloat own = texels_density(texels, x * normal.x + y * normal.y + z * normal.z), share = own / (own + guides);
        share = select((vfloat)(1.0f), share, PACKET_MASK(guides > 0.0f));
        for (int c = 0; c < 3; ++c) {
            global float *at = radiance + (size_t)c * capacity + first;
            PACKET_STORE(PACKET_LOAD(at) * share, at);
        }
    }
}
