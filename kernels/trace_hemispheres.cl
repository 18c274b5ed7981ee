// Gather Q of surface pencils: the surfels that the texels of their hemispheres see, by packets of rays through the hierarchy.

#include "lib/apart.cl"
#include "lib/bvh.cl"
#include "lib/hemisphere_rays.cl"
#include "lib/packet.cl"
#include "lib/surfel.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/material.h"
#include "shared/surface_pencil.h"

/// Of the packet at `first`, see below.
APART static void trace_hemispheres_packet(int first, global const SurfacePencil *pencils, int first_pencil, int pencil_count, int texels,
                                           int n, uint seed, uint2 shift, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels,
                                           int capacity, int first_surfel) {
    int index = first_pencil + first / texels;
    global const SurfacePencil *pencil = pencils + index;
    float4 origin = (float4)(pencil->position.xyz, 0.0f);
    float3 facing = pencil->facing.xyz;
    vfloat x, y, z;
    hemisphere_rays(pencil, first % (n * n), n, seed, shift, &x, &y, &z);
    RayPacket rays = ray_packet(x, y, z);
    packet_trace(&rays, origin, pencil->plane, 0.0f, nodes, leaves, triangles, planes);
    vint below = PACKET_MASK(rays.x * facing.x + rays.y * facing.y + rays.z * facing.z <= 0.0f);
    rays.triangle = select(rays.triangle, (vint)(-1), below);
    Surfaces scene = SURFACES;
#if PENCIL_OUTGOING || PENCIL_TEXTURES
#pragma unroll 1  // models of materials are long
#endif
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        if (PENCIL_OUTGOING && LANE_INT(below, l)) {
            Vertex nothing = meet_nothing((float3)(LANE_FLOAT(rays.x, l), LANE_FLOAT(rays.y, l), LANE_FLOAT(rays.z, l)));
            Throughput none = {(float3)(0.0f), -1.0f};
            store_vertex(surfels, capacity, first_surfel + first + l, &nothing, none);
            continue;
        }
        Hit hit = {LANE_INT(rays.triangle, l), LANE_FLOAT(rays.disparity, l)};
        float4 direction = (float4)(LANE_FLOAT(rays.x, l), LANE_FLOAT(rays.y, l), LANE_FLOAT(rays.z, l), 0.0f);
        write_surfel(surfels, capacity, first_surfel + first + l, hit, origin, direction, &scene,
                     as_uint(LANE_FLOAT(rays.x, l)) ^ as_uint(LANE_FLOAT(rays.y, l)));
    }
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH texels of pencils first_pencil .. ; `texels` entries per pencil of maps of n * n,
///          in the order of hemisphere_texel: all of them, or, where several pencils share a map, a block each in turn
/// in     : pencils (position, normal, facing, plane, key); the scene and its hierarchy; seed: of the points within texels; shift: of all
///          points, as fractions of 2^32: a digital shift, so that a sequence of them fills each texel as evenly as it fills the square
/// out    : surfels, structure of arrays of `capacity`, entry k of pencil first_pencil + p at first_surfel + p * texels + k
/// needs  : n a multiple of 4, texels a multiple of the blocks' size. Texels below the geometric horizon of a pencil see nothing.
kernel void trace_hemispheres(global const SurfacePencil *pencils, int first_pencil, int pencil_count, int texels, int n, uint seed,
                              uint2 shift, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels, int capacity,
                              int first_surfel) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= pencil_count * texels) return;
    trace_hemispheres_packet(first, pencils, first_pencil, pencil_count, texels, n, seed, shift, nodes, leaves, SURFACES_ARGUMENTS, surfels,
                             capacity, first_surfel);
}
