// Rays of surface pencils towards bright spots, beside those of their texels.

#include "lib/apart.cl"
#include "lib/bvh.cl"
#include "lib/hash.cl"
#include "lib/hemisphere.cl"
#include "lib/packet.cl"
#include "lib/spots.cl"
#include "lib/surfel.cl"
#include "shared/bvh.h"
#include "shared/material.h"

/// Share of a cone at its edge that is left out, so that rounding takes no direction out of it; light that varies over the cone is off by no more.
#define GUIDE_MARGIN 5e-4f

static inline float guide_unit(uint bits) { return (bits >> UNIT_SHIFT) * UNIT_STEP; }

/// Direction of guided ray `number`: rays take turns among the spots, each as often as its chance says.
static inline float3 guided_direction(const SpotView *v, int number, uint key, uint2 shift) {
    uint turn = hash_uint(key ^ hash_uint(shift.x)), bits = hash_uint(key + 1 + number);  // no dimension of the points decides two things
    float pick = (number + guide_unit(turn)) / SPOT_RAYS, sum = v->chance[0];
    int k = 0;
    while (k + 1 < v->count && pick >= sum) sum += v->chance[++k];
    float rise = v->opening[k] * (1.0f - GUIDE_MARGIN) * guide_unit(bits ^ shift.x),
          phi = 2.0f * M_PI_F * guide_unit(hash_uint(bits) ^ shift.y);
    float aside = sqrt(fmax(rise * (2.0f - rise), 0.0f));
    float3 t, b;
    tangent_frame(v->axis[k], &t, &b);
    return normalize(aside * cos(phi) * t + aside * sin(phi) * b + (1.0f - rise) * v->axis[k]);
}

/// Of the packet at `first`, see below.
APART static void guide_hemispheres_packet(int first, global const SurfacePencil *pencils, int first_pencil, int texels, int shared_keys,
                                           global const float4 *spots, global const float *weights, int spot_count, uint seed, uint2 shift,
                                           HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels, int capacity,
                                           global float *factors) {
    global const SurfacePencil *pencil = pencils + first_pencil + first / SPOT_RAYS;
    float4 origin = (float4)(pencil->position.xyz, 0.0f);
    SpotView view = view_spots(pencil, spots, weights, spot_count);
    // Pencils of one key, those that share a map, look elsewhere; where a pencil has its own, it does not matter which others are there.
    uint number = shared_keys ? (uint)(first_pencil + first / SPOT_RAYS) : 0u;
    uint key = hash_uint(pencil->key + hash_uint(seed ^ 0x9e3779b9u) + 0x85ebca6bu * number);
    float d[3][PENCIL_WIDTH], factor[PENCIL_WIDTH];
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float3 direction = view.count > 0 ? guided_direction(&view, first % SPOT_RAYS + l, key, shift) : pencil->normal.xyz;
        float cosine = dot(direction, pencil->normal.xyz);
        bool sees = view.count > 0 && cosine > 0.0f && dot(direction, pencil->facing.xyz) > 0.0f;
        factor[l] = sees ? cosine / (texels_density(texels, cosine) + guides_density(&view, direction)) : 0.0f;
        d[0][l] = direction.x;
        d[1][l] = direction.y;
        d[2][l] = direction.z;
    }
    RayPacket rays = ray_packet(PACKET_LOAD(d[0]), PACKET_LOAD(d[1]), PACKET_LOAD(d[2]));
    if (view.count > 0) packet_trace(&rays, origin, pencil->plane, 0.0f, nodes, leaves, triangles, planes);
    Surfaces scene = SURFACES;
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float3 direction = (float3)(d[0][l], d[1][l], d[2][l]);
        factors[first + l] = factor[l];
        if (!(factor[l] > 0.0f)) {
            Vertex nothing = meet_nothing(direction);
            Throughput none = {(float3)(0.0f), -1.0f};
            store_vertex(surfels, capacity, first + l, &nothing, none);
            continue;
        }
        Hit hit = {LANE_INT(rays.triangle, l), LANE_FLOAT(rays.disparity, l)};
        write_surfel(surfels, capacity, first + l, hit, origin, (float4)(direction, 0.0f), &scene, as_uint(d[0][l]) ^ as_uint(d[1][l]));
    }
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH guided rays, SPOT_RAYS of each pencil from first_pencil on
/// in     : pencils; texels: of each; shared_keys: 1 where pencils may have the same; spots[spot_count], their weights: what they reflect, 1 in all; seed, shift: as
///          in trace_hemispheres; the scene and its hierarchy
/// out    : surfels that the rays meet, ray k of pencil first_pencil + p at p * SPOT_RAYS + k; factors[pencil_count * SPOT_RAYS]: irradiance
///          of the pencil for radiance along the ray [sr], 0: the ray sees nothing
kernel void guide_hemispheres(global const SurfacePencil *pencils, int first_pencil, int pencil_count, int texels, int shared_keys,
                              global const float4 *spots, global const float *weights, int spot_count, uint seed, uint2 shift,
                              HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels, int capacity, global float *factors) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= pencil_count * SPOT_RAYS) return;
    guide_hemispheres_packet(first, pencils, first_pencil, texels, shared_keys, spots, weights, spot_count, seed, shift, nodes, leaves,
                             SURFACES_ARGUMENTS, surfels, capacity, factors);
}
