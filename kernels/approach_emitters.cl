// Emitters near a surface pencil: what it sees of them changes within their distance, however far away everything else is.

#include "lib/hemisphere.cl"
#include "lib/surface_pencil.cl"
#include "shared/material.h"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// launch : 1-D, one work-item per pencil of first_pencil ..
/// in     : surfels (trace_hemispheres), n x n entries per pencil; materials; near_area[material]: as emit_hemispheres
/// out    : pencils: emitters: of what light samples carry nearly all of only so much nearer or farther counts as pencils carry of it
kernel void approach_emitters(global const float *surfels, int capacity, int first_pencil, int pencil_count, int n,
                              global const Material *materials, global const float *near_area, global SurfacePencil *pencils) {
    int item = get_global_id(0);
    if (item >= pencil_count) return;
    global SurfacePencil *pencil = pencils + first_pencil + item;
    size_t c = capacity;
    float shares = 0.0f, inverse = 0.0f, most = 0.0f;
    for (int i = item * n * n; i < (item + 1) * n * n; ++i) {
        global const float *s = surfels + i;
        int m = SURFEL_CONST_INT(s, SURFEL_MATERIAL * c);
        if (SURFEL_CONST_INT(s, SURFEL_PLANE * c) < 0 || m < 0 || m == PENCIL_NO_MATERIAL || !any(materials[m].emission.xyz > 0.0f))
            continue;
        float3 step = (float3)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c]) - pencil->position.xyz;
        float square = dot(step, step), share = near_area[m] < INFINITY ? near_area[m] / (square + near_area[m]) : 1.0f;
        shares += share;
        inverse += share / fmax(sqrt(square), position_error(pencil->position.xyz));
        most = fmax(most, share);
    }
    pencil->emitters = inverse > 0.0f ? shares / (inverse * most) : INFINITY;
}
