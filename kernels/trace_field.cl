// Gather Q of the pencils of a field: the surfels that the texels of their octahedral maps see, each through a point of its own, by packets of
// rays through the hierarchy.

#include "lib/apart.cl"
#include "lib/bvh.cl"
#include "lib/octahedral.cl"
#include "lib/packet.cl"
#include "lib/surfel.cl"
#include "lib/texel_points.cl"
#include "lib/triangle.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/material.h"
#include "shared/surface_pencil.h"

/// Unit directions through points of the packet of map entries at `first`, in the order of oct_block_texel.
static inline void octahedral_rays(global const SurfacePencil *pencil, int first, int n, uint seed, uint2 shift, vfloat *x, vfloat *y,
                                   vfloat *z) {
    int column[PENCIL_WIDTH], row[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int2 texel = oct_block_texel(first + l, n);
        column[l] = texel.x;
        row[l] = texel.y;
    }
    vfloat u, v;
    texel_points(pencil->key, first, column, row, n, seed, shift, &u, &v);
    float d[3][PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float3 direction = normalize(oct_to_direction(LANE_FLOAT(u, l), LANE_FLOAT(v, l)).xyz);
        d[0][l] = direction.x;
        d[1][l] = direction.y;
        d[2][l] = direction.z;
    }
    *x = PACKET_LOAD(d[0]);
    *y = PACKET_LOAD(d[1]);
    *z = PACKET_LOAD(d[2]);
}

/// Of the packet at `first`, see below.
APART static void trace_field_packet(int first, global const SurfacePencil *pencils, int first_pencil, int n, uint seed, uint2 shift,
                                     HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels, int capacity) {
    global const SurfacePencil *pencil = pencils + first_pencil + first / (n * n);
    float4 origin = (float4)(pencil->position.xyz, 0.0f);
    vfloat x, y, z;
    octahedral_rays(pencil, first % (n * n), n, seed, shift, &x, &y, &z);
    RayPacket rays = ray_packet(x, y, z);
    packet_trace(&rays, origin, -1, PLANE_TOLERANCE, nodes, leaves, triangles, planes);
    Surfaces scene = SURFACES;
#if PENCIL_OUTGOING || PENCIL_TEXTURES
#pragma unroll 1  // models of materials are long
#endif
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        Hit hit = {LANE_INT(rays.triangle, l), LANE_FLOAT(rays.disparity, l)};
        float4 direction = (float4)(LANE_FLOAT(rays.x, l), LANE_FLOAT(rays.y, l), LANE_FLOAT(rays.z, l), 0.0f);
        write_surfel(surfels, capacity, first + l, hit, origin, direction, &scene,
                     as_uint(LANE_FLOAT(rays.x, l)) ^ as_uint(LANE_FLOAT(rays.y, l)));
    }
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH texels of pencils first_pencil .. , n * n each in the order of oct_block_texel
/// in     : pencils (position, key); the scene and its hierarchy; seed: of the points within texels; shift: of all points, as fractions of
///          2^32, see trace_hemispheres.cl
/// out    : surfels, structure of arrays of `capacity`, entry k of pencil first_pencil + p at p * n * n + k
/// needs  : n a multiple of 4. A plane within PLANE_TOLERANCE of a centre is not seen from it.
kernel void trace_field(global const SurfacePencil *pencils, int first_pencil, int pencil_count, int n, uint seed, uint2 shift,
                        HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels, int capacity) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= pencil_count * n * n) return;
    trace_field_packet(first, pencils, first_pencil, n, seed, shift, nodes, leaves, SURFACES_ARGUMENTS, surfels, capacity);
}
