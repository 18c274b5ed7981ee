// Direct light of surfels from the light samples (thesis alg. 6.2), each with its own geometry map for visibility.

#include "lib/apart.cl"
#include "lib/light_sample.cl"
#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/light.h"

/// Aims one packet at sample i; the weight is the geometry term.
static inline void aim_at_sample(const SurfelPacket *s, const VisibilityMap *map, global const LightSample *sample, float4 cop, int i,
                                 Aimed *aimed) {
    vfloat vx, vy, vz;
    sample_to_surfels(s, sample, &vx, &vy, &vz);
    aimed->weight = sample_weight(s, sample, vx, vy, vz, map->scene->bitmaps);
    aimed->faces = PACKET_BITS(PACKET_MASK(aimed->weight > 0.0f));
    if (aimed->faces) aim_packet(map, i, vx, vy, vz, aimed);
}

/// Irradiance of one packet from sample i, added to rgb.
static inline void add_light_sample(const SurfelPacket *s, const VisibilityMap *map, global const LightSample *sample, int i,
                                    const Aimed *aimed, vfloat *rgb) {
    float4 emission = sample->emission;
    if (!aimed->faces) return;
    vfloat weight = aimed->weight * sample_share(s, map, aimed, i, sample);
    rgb[0] = fma(weight, (vfloat)(emission.x), rgb[0]);
    rgb[1] = fma(weight, (vfloat)(emission.y), rgb[1]);
    rgb[2] = fma(weight, (vfloat)(emission.z), rgb[2]);
}

/// Of the packet at `first`, see below.
APART static void light_surfels_packet(int first, global const float *surfels, int capacity, int surfel_count,
                                       global const LightSample *samples, int sample_count, global const float4 *cops,
                                       global const int2 *cells, global const int4 *groups, global const Hit *hits, SURFACES_PARAMETERS,
                                       int n, HIERARCHY_PARAMETERS, global float *outgoing, int accumulate) {
    Surfaces scene = SURFACES;
    VisibilityMap map = {cells, groups, hits, triangles, planes, n, nodes, leaves, &scene};
    SurfelPacket packets[PENCIL_BLOCK];
    vfloat rgb[PENCIL_BLOCK][3];
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        packets[p] = load_surfels(surfels, capacity, first + p * PENCIL_WIDTH);
        rgb[p][0] = rgb[p][1] = rgb[p][2] = 0.0f;
    }
    for (int i = 0; i < sample_count; ++i) {
        float4 cop = (float4)(cops[i].xyz, 0.0f);
        Aimed aimed[PENCIL_BLOCK];
        for (int p = 0; p < PENCIL_BLOCK; ++p) aim_at_sample(packets + p, &map, samples + i, cop, i, aimed + p);
        for (int p = 0; p < PENCIL_BLOCK; ++p) add_light_sample(packets + p, &map, samples + i, i, aimed + p, rgb[p]);
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        scatter_irradiance(surfels, capacity, first + p * PENCIL_WIDTH, rgb[p][0], rgb[p][1], rgb[p][2], outgoing, accumulate);
}

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH surfels
/// in     : surfels; samples[sample_count]; cops[sample_count]; cells, groups, hits: tiles of n x n of the samples; with PENCIL_BVH nodes
/// and leaves
///          instead
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to if `accumulate`
kernel void light_surfels(global const float *surfels, int capacity, int surfel_count, global const LightSample *samples, int sample_count,
                          global const float4 *cops, global const int2 *cells, global const int4 *groups, global const Hit *hits,
                          SURFACES_PARAMETERS, int n, HIERARCHY_PARAMETERS, global float *outgoing, int accumulate) {
    int first = get_global_id(0) * PENCIL_BLOCK * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    light_surfels_packet(first, surfels, capacity, surfel_count, samples, sample_count, cops, cells, groups, hits, SURFACES_ARGUMENTS, n,
                         nodes, leaves, outgoing, accumulate);
}
