// What probing rays meet, on which centres of projection are placed (thesis 6.2.2).

#include "lib/bvh.cl"
#include "lib/packet.cl"
#include "lib/surfel.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/material.h"

/// launch : 1-D, one work-item per ray; there are few of them, all from other origins, so each fills a packet with itself
/// in     : origins[count], directions[count] (unit length), own[count]: the plane that each starts on, -1: none; the scene and its
///          hierarchy
/// out    : surfels, structure of arrays of `capacity`: what each ray meets first; distances[count] [scene units], INFINITY if nothing
kernel void trace_probing_rays(global const float4 *origins, global const float4 *directions, global const int *own, int count,
                               HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels, int capacity, global float *distances) {
    int i = get_global_id(0);
    if (i >= count) return;
    float4 origin = (float4)(origins[i].xyz, 0.0f), direction = (float4)(directions[i].xyz, 0.0f);
    RayPacket rays = ray_packet((vfloat)(direction.x), (vfloat)(direction.y), (vfloat)(direction.z));
    packet_trace(&rays, origin, own[i], 0.0f, nodes, leaves, triangles, planes);
    Hit hit = {LANE_INT(rays.triangle, 0), LANE_FLOAT(rays.disparity, 0)};
    Surfaces scene = SURFACES;
    write_surfel(surfels, capacity, i, hit, origin, direction, &scene, hash_uint((uint)i));
    distances[i] = LANE_FLOAT(rays.nearest, 0);
}
