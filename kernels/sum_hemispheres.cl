// What a surface pencil knows when its texels are lit: irradiance, harmonic mean distance, distances at the horizon.

/// launch : 1-D, one work-item per pencil of first_pencil ..
/// in     : radiance[3][capacity] that the texels send, distances[capacity], n x n entries per pencil (trace_hemispheres)
/// out    : pencils: irradiance = pi / n^2 * sum of radiance; position.w, ring
kernel void sum_hemispheres(global const float *radiance, global const float *distances, int capacity, int first_pencil, int pencil_count,
                            int n, global SurfacePencil *pencils) {
    int item = get_global_id(0);
    if (item >= pencil_count) return;
    global SurfacePencil *pencil = pencils + first_pencil + item;
    float3 sum = (float3)(0.0f);
    float inverse = 0.0f;
    float ring[RING_SECTORS];
    for (int s = 0; s < RING_SECTORS; ++s) ring[s] = INFINITY;
    for (int i = 0; i < n * n; ++i) {
        size_t at = (size_t)item * n * n + i;
        sum += (float3)(radiance[at], radiance[capacity + at], radiance[2 * (size_t)capacity + at]);
        float distance = distances[at];
        inverse += 1.0f / distance;
        int2 texel = hemisphere_texel(i, n);
        if (texel.x > 0 && texel.x < n - 1 && texel.y > 0 && texel.y < n - 1) continue;
        // On the rim of the disc the concentric map keeps the direction's octant.
        int sector = ring_sector(2 * texel.x + 1 - n, 2 * texel.y + 1 - n);
        ring[sector] = fmin(ring[sector], distance);
    }
    pencil->irradiance = (float4)(sum * (M_PI_F / (n * n)), 0.0f);
    pencil->position.w = inverse > 0.0f ? n * n / inverse : INFINITY;
    for (int s = 0; s < RING_SECTORS; ++s) pencil->ring[s] = ring[s];
}
