// Puts surface pencils on surfels.

#include "lib/surface_pencil.cl"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// How much nearer: well above the rounding of positions, in terms of them, and a small share of the distance.
#define PLACE_NEARER 30.0f
#define PLACE_SHARE 1e-2f

/// launch : 1-D, one work-item per new pencil
/// in     : surfels; chosen[count]: the surfel of each pencil; keys[count]: its key; views[count]: xyz: where that surfel was seen from,
///          w: radius [scene units]; spacing: of the lattice of film pencils that they join [pixels], 0: none
/// out    : pencils[first ..]: position, normal, facing, plane, key, spacing; no emitters near, the rest 0 until they are measured
/// A pencil lies a little nearer to its viewer than the surfel: where two walls meet, it must lie on the side of the second wall that was
/// seen.
kernel void place_surface_pencils(global const float *surfels, int capacity, global const int *chosen, global const uint *keys,
                                  global const float4 *views, int count, int spacing, int first, global SurfacePencil *pencils) {
    int item = get_global_id(0);
    if (item >= count) return;
    global const float *s = surfels + chosen[item];
    global SurfacePencil *pencil = pencils + first + item;
    size_t c = capacity;
    float3 x = (float3)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c]), towards = views[item].xyz - x;
    // Seen through mirrors and glass: the side it was seen from is not the viewer's.
    if (PENCIL_LOBES) towards = length(towards) * (float3)(s[SURFEL_OX * c], s[SURFEL_OY * c], s[SURFEL_OZ * c]);
    float nearer = PLACE_NEARER * position_error(x);
    pencil->position = (float4)(x + towards * fmin(nearer / fmax(length(towards), nearer), PLACE_SHARE), 0.0f);
    pencil->normal = (float4)(s[SURFEL_NX * c], s[SURFEL_NY * c], s[SURFEL_NZ * c], views[item].w);
    pencil->facing = (float4)(s[SURFEL_GX * c], s[SURFEL_GY * c], s[SURFEL_GZ * c], 0.0f);
    for (int k = 0; k < 2 * RING_SECTORS; ++k) pencil->horizon_x[k] = pencil->horizon_y[k] = 0.0f;
    pencil->plane = SURFEL_CONST_INT(s, SURFEL_PLANE * c);
    pencil->key = keys[item];
    pencil->spacing = spacing;
    pencil->emitters = INFINITY;
}
