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

/// Unit directions of the packet of guided rays at `first`: rays take turns among the spots, each as often as its chance says.
static inline void guided_directions(const SpotView *v, int first, uint key, uint2 shift, vfloat *x, vfloat *y, vfloat *z) {
    vint number = (vint)(first) + PACKET_LANES;
    vuint bits = hash_packet((vuint)(key + 1u) + PACKET_AS_UINT(number));  // no dimension of the points decides two things
    float turn = (hash_uint(key ^ hash_uint(shift.x)) >> UNIT_SHIFT) * UNIT_STEP, sum = v->chance[0];
    vfloat pick = (PACKET_TO_FLOAT(number) + turn) / SPOT_RAYS, opening = (vfloat)(v->opening[0]);
    vfloat nx = (vfloat)(v->axis[0].x), ny = (vfloat)(v->axis[0].y), nz = (vfloat)(v->axis[0].z);
    for (int k = 1; k < v->count; sum += v->chance[k++]) {
        vint later = PACKET_MASK(pick >= sum);
        opening = select(opening, (vfloat)(v->opening[k]), later);
        nx = select(nx, (vfloat)(v->axis[k].x), later);
        ny = select(ny, (vfloat)(v->axis[k].y), later);
        nz = select(nz, (vfloat)(v->axis[k].z), later);
    }
    vfloat rise = opening * (1.0f - GUIDE_MARGIN) * PACKET_UNIT(bits ^ shift.x),
           phi = 2.0f * M_PI_F * PACKET_UNIT(hash_packet(bits) ^ shift.y);
    vfloat aside = sqrt(fmax(rise * (2.0f - rise), (vfloat)(0.0f))), c = aside * cos(phi), s = aside * sin(phi), along = 1.0f - rise;
    // In the frame of tangent_frame() about the axis.
    vfloat sign = copysign((vfloat)(1.0f), nz), k = -1.0f / (sign + nz), m = nx * ny * k;
    *x = c * (1.0f + sign * nx * nx * k) + s * m + along * nx;
    *y = c * sign * m + s * (sign + ny * ny * k) + along * ny;
    *z = along * nz - c * sign * nx - s * ny;
    vfloat inverse = 1.0f / sqrt(*x * *x + *y * *y + *z * *z);
    *x *= inverse;
    *y *= inverse;
    *z *= inverse;
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
    float3 normal = pencil->normal.xyz, facing = pencil->facing.xyz;
    vfloat x = (vfloat)(normal.x), y = (vfloat)(normal.y), z = (vfloat)(normal.z), factor = (vfloat)(0.0f);
    if (view.count > 0) {
        guided_directions(&view, first % SPOT_RAYS, key, shift, &x, &y, &z);
        vfloat cosine = x * normal.x + y * normal.y + z * normal.z;
        vint sees = PACKET_MASK(cosine > 0.0f) & PACKET_MASK(x * facing.x + y * facing.y + z * facing.z > 0.0f);
        factor = select(factor, cosine / (texels_density(texels, cosine) + guides_density(&view, x, y, z)), sees);
    }
    PACKET_STORE(factor, factors + first);
    RayPacket rays = ray_packet(x, y, z);
    if (view.count > 0) packet_trace(&rays, origin, pencil->plane, 0.0f, nodes, leaves, triangles, planes);
    Surfaces scene = SURFACES;
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float3 direction = (float3)(LANE_FLOAT(x, l), LANE_FLOAT(y, l), LANE_FLOAT(z, l));
        if (!(LANE_FLOAT(factor, l) > 0.0f)) {
            Vertex nothing = meet_nothing(direction);
            Throughput none = {(float3)(0.0f), -1.0f};
            store_vertex(surfels, capacity, first + l, &nothing, none);
            continue;
        }
        Hit hit = {LANE_INT(rays.triangle, l), LANE_FLOAT(rays.disparity, l)};
        write_surfel(surfels, capacity, first + l, hit, origin, (float4)(direction, 0.0f), &scene,
                     as_uint(direction.x) ^ as_uint(direction.y));
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
