// Which surface pencils light each texel of the surface pencils, once for all bounces.

#include "lib/stand_in.cl"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// launch : 1-D, one work-item per surfel
/// in     : surfels; pencils and their grid; the hierarchy of the scene, for pencils that stand in
/// out    : links[surfel_count]: pencils, -1: none, as for surfels that reflect nothing; factors[surfel_count]: their weights
kernel void link_surfels(global const float *surfels, int capacity, int surfel_count, global const SurfacePencil *pencils, PencilGrid grid,
                         global const int *starts, global const float *entries, HIERARCHY_PARAMETERS, global const Triangle *triangles,
                         global const float4 *planes, global int4 *links, global float4 *factors) {
    int i = get_global_id(0);
    if (i >= surfel_count) return;
    size_t c = capacity;
    global const float *s = surfels + i;
    PencilLinks found = {{-1, -1, -1, -1}, {0.0f, 0.0f, 0.0f, 0.0f}};
    bool reflects = s[SURFEL_ALBEDO_R * c] > 0.0f || s[SURFEL_ALBEDO_G * c] > 0.0f || s[SURFEL_ALBEDO_B * c] > 0.0f;
    int plane = SURFEL_CONST_INT(s, SURFEL_PLANE * c);
    if (plane >= 0 && reflects)
        found = nearest_pencils(pencils, grid, starts, entries, (float3)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c]),
                                (float3)(s[SURFEL_NX * c], s[SURFEL_NY * c], s[SURFEL_NZ * c]),
                                (float3)(s[SURFEL_GX * c], s[SURFEL_GY * c], s[SURFEL_GZ * c]), plane, nodes, leaves, triangles, planes);
    links[i] = vload4(0, found.index);
    factors[i] = vload4(0, found.weight);
}
