// Direct light of the light samples along the lobes of some surfels, beside what light_surfels makes of their irradiance.

#include "lib/apart.cl"
#include "lib/film_chains.cl"
#include "lib/lobe_light.cl"
#include "lib/packet_visibility.cl"
#include "lib/surfel_packet.cl"
#include "shared/bvh.h"
#include "shared/light.h"

/// Shares of light below this are not worth a ray.
#define LOBE_LEAST 1e-6f

/// Of the packet at `first`, see below.
APART static void light_lobes_packet(int first, global const float *surfels, int capacity, global const int *chosen, int chosen_count,
                                     int chains, global const LightSample *samples, int sample_count, HIERARCHY_PARAMETERS,
                                     SURFACES_PARAMETERS, global float *outgoing) {
    Surfaces scene = SURFACES;
    Vertex v[PENCIL_WIDTH];
    float3 sum[PENCIL_WIDTH];
    float o[3][PENCIL_WIDTH];
    int own[PENCIL_WIDTH], along[PENCIL_WIDTH];
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        v[l] = load_vertex(surfels, capacity, chosen[min(first + l, chosen_count - 1)], materials, bitmaps);
        sum[l] = (float3)(0.0f);
        o[0][l] = v[l].x.x;
        o[1][l] = v[l].x.y;
        o[2][l] = v[l].x.z;
        own[l] = v[l].plane;
        along[l] = chains_along_lobes(v + l, (float3)(1.0f), chains);
    }
    for (int i = 0; i < sample_count; ++i) {
        float3 light[PENCIL_WIDTH];
        float d[3][PENCIL_WIDTH], end[PENCIL_WIDTH];
        bool any_lit = false;
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            Incident in = incident_light(samples + i, v[l].x, 1.0f, bitmaps);
            bool facing = first + l < chosen_count && in.form > 0.0f;
            light[l] = facing ? lobe_radiance(v + l, (float3)(1.0f), &in, samples[i].emission.xyz, along[l]) : (float3)(0.0f);
            float3 size = fabs(light[l]), even = samples[i].emission.xyz * in.form;
            bool lit = size.x + size.y + size.z > LOBE_LEAST * (even.x + even.y + even.z);
            bool far = samples[i].position.w == LIGHT_INFINITE;
            float3 segment = far ? in.direction : samples[i].position.xyz - v[l].x;
            d[0][l] = segment.x;
            d[1][l] = segment.y;
            d[2][l] = segment.z;
            end[l] = lit ? (far ? INFINITY : FAR_END) : -1.0f;
            any_lit |= lit;
        }
        if (!any_lit) continue;
        LaneRays rays = lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), PACKET_LOAD(d[0]), PACKET_LOAD(d[1]),
                                  PACKET_LOAD(d[2]), PACKET_LOAD(own), PACKET_LOAD(end));
        vfloat share = rays_share(&rays, PACKET_BITS(PACKET_MASK(rays.nearest > 0.0f)), &scene, nodes, leaves, triangles, planes);
        for (int l = 0; l < PENCIL_WIDTH; ++l) sum[l] += LANE_FLOAT(share, l) * light[l];
    }
    for (int l = 0; l < PENCIL_WIDTH && first + l < chosen_count; ++l) {
        int i = chosen[first + l];
        outgoing[i] += sum[l].x;
        outgoing[(size_t)capacity + i] += sum[l].y;
        outgoing[2 * (size_t)capacity + i] += sum[l].z;
    }
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH of the chosen surfels
/// in     : surfels; chosen[chosen_count]: those with lobes; chains: so many rays go along the lobes of each and carry their share (follow_surfels.cl);
///          samples[sample_count]; the scene
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to
kernel void light_lobes(global const float *surfels, int capacity, global const int *chosen, int chosen_count, int chains,
                        global const LightSample *samples, int sample_count, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS,
                        global float *outgoing) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= chosen_count) return;
    light_lobes_packet(first, surfels, capacity, chosen, chosen_count, chains, samples, sample_count, nodes, leaves, SURFACES_ARGUMENTS,
                       outgoing);
}
