// Direct light of surfels that are read only in the mean, such as the texels of surface pencils: every packet draws a few of the light
// samples in proportion to what they would send it if nothing stood between, and follows rays to those.

#include "lib/hash.cl"
#include "lib/light_sample.cl"
#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/light.h"

/// Samples come in groups: a point of a triangle and its two rotations among the corners (pencils/light_samples.cpp).
#define LIGHT_GROUP 3

/// What sample i would send to a packet: the sum over its surfels.
static inline float sample_importance(const SurfelPacket *s, global const LightSample *sample) {
    float4 cop = sample->position, e = sample->emission;
    return packet_sum(sample_weight(s, sample, s->x - cop.x, s->y - cop.y, s->z - cop.z)) * (e.x + e.y + e.z);
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels
/// in     : surfels; samples[sample_count], of which packets consider every stride-th group from a random start; draws: samples that a
/// packet takes, repetitions included in/out : outgoing[3][capacity] [W m^-2 sr^-1], an unbiased estimate of light_surfels' result is added
kernel void sample_lights(global const float *surfels, int capacity, int surfel_count, global const LightSample *samples, int sample_count,
                          global const Triangle *triangles, global const float4 *planes, global const BvhNode *nodes,
                          global const int *leaves, int stride, int draws, uint seed, global float *outgoing) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    VisibilityMap map = {0, 0, 0, triangles, planes, 0, nodes, leaves};
    SurfelPacket s = load_surfels(surfels, capacity, first);
    uint bits = hash_uint((uint)(first / PENCIL_WIDTH) ^ seed);
    int start = LIGHT_GROUP * (bits % (uint)stride), step = LIGHT_GROUP * stride;
    float total = 0.0f;
    for (int group = start; group < sample_count; group += step)
        for (int i = group; i < min(group + LIGHT_GROUP, sample_count); ++i) total += sample_importance(&s, samples + i);
    if (!(total > 0.0f)) return;
    // Systematic resampling: draws at equal steps of the running sum, from a random first.
    float interval = total / draws, next = interval * (hash_uint(bits) >> UNIT_SHIFT) * UNIT_STEP, sum = 0.0f;
    vfloat r = 0.0f, g = 0.0f, b = 0.0f;
    for (int group = start; group < sample_count; group += step)
        for (int i = group; i < min(group + LIGHT_GROUP, sample_count); ++i) {
            float importance = sample_importance(&s, samples + i);
            sum += importance;
            int drawn = 0;
            for (; next < sum; next += interval) ++drawn;
            if (!drawn) continue;
            float4 cop = (float4)(samples[i].position.xyz, 0.0f), e = samples[i].emission * (drawn * interval / importance * stride);
            vfloat weight = sample_weight(&s, samples + i, s.x - cop.x, s.y - cop.y, s.z - cop.z);
            int lit = settle_by_rays(&s, &map, cop, PACKET_BITS(PACKET_MASK(weight > 0.0f)));
            weight = select((vfloat)(0.0f), weight, PACKET_FROM_BITS(lit));
            r = fma(weight, (vfloat)(e.x), r);
            g = fma(weight, (vfloat)(e.y), g);
            b = fma(weight, (vfloat)(e.z), b);
        }
    scatter_irradiance(surfels, capacity, first, r, g, b, outgoing, 1);
}
