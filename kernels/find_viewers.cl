// Which pencils some surfels see: those that matter for a view of a field.

#include "lib/rays.cl"
#include "lib/surfel_packet.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"

/// launch : 1-D, one work-item per pencil
/// in     : surfels of `capacity`; cops[pencil_count] (xyz, scene units); the scene and its hierarchy
/// out    : seen[pencil_count]: the surfels that see it in front of them, of the first surfel_count
kernel void find_viewers(global const float *surfels, int capacity, int surfel_count, global const float4 *cops, int pencil_count,
                         HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes, global int *seen) {
    int i = get_global_id(0);
    if (i >= pencil_count) return;
    float4 cop = cops[i];
    int count = 0;
    for (int first = 0; first < surfel_count; first += PENCIL_WIDTH) {
        SurfelPacket s = load_surfels(surfels, capacity, first);
        vfloat vx = s.x - cop.x, vy = s.y - cop.y, vz = s.z - cop.z;
        vint faces = PACKET_MASK(packet_cosine_towards(&s, vx, vy, vz) > 0.0f) & PACKET_MASK(first + PACKET_LANES < surfel_count);
        if (!PACKET_ANY(faces)) continue;
        LaneRays r = lane_rays(s.x, s.y, s.z, -vx, -vy, -vz, s.plane, select((vfloat)(-1.0f), (vfloat)(1.0f), faces));
        lanes_trace(&r, true, nodes, leaves, triangles, planes);
        count += popcount(PACKET_BITS(faces & PACKET_MASK(r.triangle < 0)));
    }
    seen[i] = count;
}
