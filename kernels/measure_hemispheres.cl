// What a surface pencil knows of the geometry about it: harmonic mean distance and horizon.

#include "lib/hemisphere.cl"
#include "lib/surface_pencil.cl"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// Planes nearer to a pencil than this share of its position's rounding count as this far away.
#define HORIZON_TINY 0.1f

/// From the pencil to surfel i [scene units].
static inline float3 step_to_surfel(global const float *surfels, size_t capacity, size_t i, global const SurfacePencil *pencil) {
    global const float *s = surfels + i;
    return (float3)(s[SURFEL_X * capacity], s[SURFEL_Y * capacity], s[SURFEL_Z * capacity]) - pencil->position.xyz;
}

/// The line in which the plane of surfel i cuts the tangent plane of the pencil, as SurfacePencil.horizon_x, horizon_y.
static inline float2 horizon_line(global const float *surfels, size_t capacity, size_t i, global const SurfacePencil *pencil) {
    global const float *s = surfels + i;
    float3 g = (float3)(s[SURFEL_GX * capacity], s[SURFEL_GY * capacity], s[SURFEL_GZ * capacity]), t, b;
    tangent_frame(pencil->normal.xyz, &t, &b);
    return (float2)(dot(g, t), dot(g, b)) /
           fmin(dot(step_to_surfel(surfels, capacity, i, pencil), g), -HORIZON_TINY * position_error(pencil->position.xyz));
}

/// launch : 1-D, one work-item per pencil of first_pencil ..
/// in     : surfels from first_surfel on, n x n entries per pencil (trace_hemispheres)
/// out    : pencils: position.w, horizon
kernel void measure_hemispheres(global const float *surfels, int capacity, int first_surfel, int first_pencil, int pencil_count, int n,
                                global SurfacePencil *pencils) {
    int item = get_global_id(0);
    if (item >= pencil_count) return;
    global SurfacePencil *pencil = pencils + first_pencil + item;
    float inverse = 0.0f, nearest[2 * RING_SECTORS];  // the nearest plane of each sector, then the next
    size_t blocker[2 * RING_SECTORS];
    int plane[2 * RING_SECTORS];
    for (int s = 0; s < 2 * RING_SECTORS; ++s) {
        nearest[s] = INFINITY;
        plane[s] = -1;
    }
    for (int i = 0; i < n * n; ++i) {
        size_t at = (size_t)first_surfel + (size_t)item * n * n + i;
        int met = SURFEL_CONST_INT(surfels, (size_t)SURFEL_PLANE * capacity + at);
        if (met < 0) continue;
        float distance = length(step_to_surfel(surfels, capacity, at, pencil));
        inverse += 1.0f / fmax(distance, HORIZON_TINY * position_error(pencil->position.xyz));
        int2 texel = hemisphere_texel(i, n);
        if (texel.x > 0 && texel.x < n - 1 && texel.y > 0 && texel.y < n - 1) continue;
        // On the rim of the disc the concentric map keeps the direction's octant.
        int sector = ring_sector(2 * texel.x + 1 - n, 2 * texel.y + 1 - n);
        int slot = met == plane[sector] || distance < nearest[sector] ? sector : sector + RING_SECTORS;
        if (!(distance < nearest[slot])) continue;
        if (slot == sector && met != plane[sector]) {
            nearest[sector + RING_SECTORS] = nearest[sector];
            blocker[sector + RING_SECTORS] = blocker[sector];
            plane[sector + RING_SECTORS] = plane[sector];
        }
        nearest[slot] = distance;
        blocker[slot] = at;
        plane[slot] = met;
    }
    pencil->position.w = inverse > 0.0f ? n * n / inverse : INFINITY;
    for (int s = 0; s < 2 * RING_SECTORS; ++s) {
        float2 line = nearest[s] < INFINITY ? horizon_line(surfels, capacity, blocker[s], pencil) : (float2)(0.0f);
        pencil->horizon_x[s] = line.x;
        pencil->horizon_y[s] = line.y;
    }
}
