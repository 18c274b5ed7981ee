// Direct light of surfels that are read only in the mean, such as the texels of surface pencils: every few surfels draw some of the light
// samples, mostly in proportion to what they would send it if nothing stood between, and follows rays to those.

#include "lib/apart.cl"
#include "lib/hash.cl"
#include "lib/light_sample.cl"
#include "lib/lobe_light.cl"
#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/surfel_packet.cl"
#include "lib/viewer.cl"
#include "lib/visibility.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/light.h"

/// Samples come in groups: a point of a triangle and its two rotations among the corners (pencils/light_samples.cpp).
#define LIGHT_GROUP 3
/// Share of the draws that all candidates have alike: what would send most may stand behind a wall (defensive mixture, Hesterberg 1995).
#define LIGHT_EVEN 0.25f

#define LIGHT_PACKETS (LIGHT_SURFELS / PENCIL_WIDTH)

typedef struct LightGroup {
    SurfelPacket s[LIGHT_PACKETS];
    vint passes[LIGHT_PACKETS];  // lanes that take light from behind, too
    int lobes[LIGHT_PACKETS];    // bits of lanes that have some
    vfloat r[LIGHT_PACKETS], g[LIGHT_PACKETS], b[LIGHT_PACKETS];
} LightGroup;

/// What sample i would send to a group: the sum over its surfels, in the same order at any width.
static inline float sample_importance(const LightGroup *group, global const LightSample *sample, global const half *tables) {
    float4 e = sample->emission;
    vfloat weight[LIGHT_PACKETS];
    for (int p = 0; p < LIGHT_PACKETS; ++p) {
        vfloat vx, vy, vz;
        const SurfelPacket *s = group->s + p;
        sample_to_surfels(s, sample, &vx, &vy, &vz);
#if PENCIL_LOBES
        SurfelPacket turned = turned_to(s, group->passes[p], vx, vy, vz);
        s = &turned;
#endif
        weight[p] = sample_weight(s, sample, vx, vy, vz, tables);
    }
    for (int half_ = LIGHT_PACKETS / 2; half_ > 0; half_ /= 2)
        for (int p = 0; p < half_; ++p) weight[p] += weight[p + half_];
    return packet_sum(weight[0]) * (e.x + e.y + e.z);
}

/// Samples that a group considers: every alone_step-th of the first `alone`, then every so many-th group.
typedef struct Candidates {
    int alone, alone_step;
    int begin, skip;  // first sample of the groups; samples between two of them
} Candidates;

static inline int next_candidate(const Candidates *c, int i) {
    if (i < c->alone) return i + c->alone_step < c->alone ? i + c->alone_step : c->begin;
    return (i - c->alone) % LIGHT_GROUP < LIGHT_GROUP - 1 ? i + 1 : i + 1 + c->skip;
}

static inline void load_group(LightGroup *group, global const float *surfels, int capacity, int first, global const Material *materials) {
    for (int p = 0; p < LIGHT_PACKETS; ++p) {
        group->s[p] = load_surfels(surfels, capacity, first + p * PENCIL_WIDTH);
        group->r[p] = group->g[p] = group->b[p] = 0.0f;
#if PENCIL_LOBES
        group->lobes[p] = lanes_with_lobes(surfels, capacity, first + p * PENCIL_WIDTH, materials);
        group->passes[p] = lanes_that_pass(surfels, capacity, first + p * PENCIL_WIDTH, materials, group->lobes[p]);
#endif
    }
}

/// Of the group at `first`, see below.
APART static void sample_lights_group(int first, global const float *surfels, int capacity, int surfel_count,
                                      global const SurfacePencil *viewers, int first_viewer, int texels, global const LightSample *samples,
                                      int sample_count, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, float area_factor, int alone,
                                      int alone_step, int stride, int draws, uint seed, global float *outgoing) {
    Surfaces scene = SURFACES;
    VisibilityMap map = {0, 0, 0, triangles, planes, 0, nodes, leaves, &scene};
    LightGroup group;
    load_group(&group, surfels, capacity, first, materials);
    uint bits = hash_uint(seen_number(viewers, first_viewer, texels, first) ^ seed);
    Candidates c = {alone, alone_step, alone + LIGHT_GROUP * (int)(bits % (uint)stride), LIGHT_GROUP * (stride - 1)};
    int start = (int)(hash_uint(bits ^ 0x9e3779b9u) % (uint)alone_step);
    start = start < alone ? start : c.begin;
#if PENCIL_LOBES
    float lobes[LIGHT_PACKETS][3][PENCIL_WIDTH] = {{{0.0f}}};
#endif
    float total = 0.0f;
    int reaching = 0;
    for (int i = start; i < sample_count; i = next_candidate(&c, i)) {
        float importance = sample_importance(&group, samples + i, bitmaps) * (i < alone ? alone_step : stride);
        total += importance;
        reaching += importance > 0.0f;
    }
    if (!(total > 0.0f)) return;
    float even = LIGHT_EVEN * total / reaching;
    // Systematic resampling: draws at equal steps of the running sum, from a random first.
    float interval = total / draws, next = interval * (hash_uint(bits) >> UNIT_SHIFT) * UNIT_STEP, sum = 0.0f;
    for (int i = start; i < sample_count; i = next_candidate(&c, i)) {
        float importance = sample_importance(&group, samples + i, bitmaps) * (i < alone ? alone_step : stride);
        if (!(importance > 0.0f)) continue;
        importance = (1.0f - LIGHT_EVEN) * importance + even;
        sum += importance;
        int drawn = 0;
        for (; next < sum; next += interval) ++drawn;
        if (!drawn) continue;
        float4 e = samples[i].emission * (drawn * interval / importance * (i < alone ? alone_step : stride));
        for (int p = 0; p < LIGHT_PACKETS; ++p) {
            const SurfelPacket *s = group.s + p;
            vfloat vx, vy, vz;
            sample_to_surfels(s, samples + i, &vx, &vy, &vz);
            vfloat weight = sample_weight(s, samples + i, vx, vy, vz, bitmaps);
            vint facing = PACKET_MASK(weight > 0.0f);
#if PENCIL_LOBES
            SurfelPacket turned = turned_to(s, group.passes[p], vx, vy, vz);
            facing |= PACKET_MASK(sample_weight(&turned, samples + i, vx, vy, vz, bitmaps) > 0.0f);
#endif
            vfloat share = sample_share_by_rays(s, &map, samples + i, PACKET_BITS(facing));
#if PENCIL_LOBES
            add_lobes(lobes[p], group.lobes[p], share, samples + i, surfels, capacity, first + p * PENCIL_WIDTH, materials, bitmaps, e,
                      area_factor);
#endif
            weight *= share;
            group.r[p] = fma(weight, (vfloat)(e.x), group.r[p]);
            group.g[p] = fma(weight, (vfloat)(e.y), group.g[p]);
            group.b[p] = fma(weight, (vfloat)(e.z), group.b[p]);
        }
    }
    for (int p = 0; p < LIGHT_PACKETS; ++p) {
        scatter_irradiance(surfels, capacity, first + p * PENCIL_WIDTH, group.r[p], group.g[p], group.b[p], outgoing, 1);
#if PENCIL_LOBES
        store_rgb(outgoing, capacity, first + p * PENCIL_WIDTH, PACKET_LOAD(lobes[p][0]), PACKET_LOAD(lobes[p][1]),
                  PACKET_LOAD(lobes[p][2]), 1);
#endif
    }
}

/// launch : 1-D, one work-item per group of LIGHT_SURFELS surfels, at any width of packets
/// in     : surfels; viewers[first_viewer ..]: who sees them, `texels` of them each, a multiple of LIGHT_SURFELS, or 0; samples[sample_count]: `alone` that are each a light of its own, of which groups consider every alone_step-th, and those
///          of wide lights, every stride-th group of samples, each from a random start; area_factor: see lobe_light.cl; draws: samples that a
///          group takes, repetitions included
/// in/out : outgoing[3][capacity] [W m^-2 sr^-1], an unbiased estimate of light_surfels' result is added
kernel void sample_lights(global const float *surfels, int capacity, int surfel_count, global const SurfacePencil *viewers,
                          int first_viewer, int texels, global const LightSample *samples, int sample_count, HIERARCHY_PARAMETERS,
                          SURFACES_PARAMETERS, float area_factor, int alone, int alone_step, int stride, int draws, uint seed,
                          global float *outgoing) {
    int first = get_global_id(0) * LIGHT_SURFELS;
    if (first >= surfel_count) return;
    sample_lights_group(first, surfels, capacity, surfel_count, viewers, first_viewer, texels, samples, sample_count, nodes, leaves,
                        SURFACES_ARGUMENTS, area_factor, alone, alone_step, stride, draws, seed, outgoing);
}
