// Which pencils each surfel sees, one bit each: V(x, c_i) of thesis eq. (5.17) for a whole set.

#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"
#include "shared/geometry.h"
#include "shared/types.h"

/// Aims one packet at pencil i.
static inline void aim_at_centre(const SurfelPacket *s, const VisibilityMap *map, float4 cop, int i, Aimed *aimed) {
    vfloat vx = s->x - cop.x, vy = s->y - cop.y, vz = s->z - cop.z;
    aimed->faces = PACKET_BITS(PACKET_MASK(packet_cosine_towards(s, vx, vy, vz) > 0.0f));
    if (aimed->faces) aim_packet(map, i, vx, vy, vz, aimed);
}

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH surfels
/// in     : surfels; cops[pencil_count]; cells, groups, hits: tiles of n x n of those pencils, folded
/// out    : mask[word][capacity]: bit i % WORD_BITS of word i / WORD_BITS is set if pencil i sees the surfel from the side that is shaded
kernel void test_visibility(global const float *surfels, int capacity, int surfel_count, global const float4 *cops, int pencil_count,
                            global const int2 *cells, global const int4 *groups, global const Hit *hits, global const Triangle *triangles,
                            global const float4 *planes, int n, global uint *mask) {
    int first = get_global_id(0) * PENCIL_BLOCK * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    VisibilityMap map = {cells, groups, hits, triangles, planes, n};
    SurfelPacket packets[PENCIL_BLOCK];
    vint bits[PENCIL_BLOCK];
    for (int p = 0; p < PENCIL_BLOCK; ++p) packets[p] = load_surfels(surfels, capacity, first + p * PENCIL_WIDTH);
    for (int word = 0; word * WORD_BITS < pencil_count; ++word) {
        for (int p = 0; p < PENCIL_BLOCK; ++p) bits[p] = 0;
        for (int i = WORD_BITS * word; i < min(WORD_BITS * word + WORD_BITS, pencil_count); ++i) {
            float4 cop = (float4)(cops[i].xyz, 0.0f);
            Aimed aimed[PENCIL_BLOCK];
            for (int p = 0; p < PENCIL_BLOCK; ++p) aim_at_centre(packets + p, &map, cop, i, aimed + p);
            for (int p = 0; p < PENCIL_BLOCK; ++p)
                bits[p] |= PACKET_FROM_BITS(packet_visible(packets + p, &map, aimed + p, i, cop)) & (int)(1u << (i % WORD_BITS));
        }
        for (int p = 0; p < PENCIL_BLOCK; ++p)
            PACKET_STORE(bits[p], (global int *)mask + (size_t)word * capacity + first + p * PENCIL_WIDTH);
    }
}
