// What a light sample sends to packets of surfels (thesis alg. 6.2), visibility apart.
// DEVIATION: cos cos / r^2 becomes cos cos / (r^2 + A/pi), A the area the sample stands for: the form factor of a disc of that area, exact
// on its axis. It is bounded where r -> 0 and tends to the printed form as A does to 0. Point lights have A = 0 and cos_l = 1.

#include "lib/light_profile.cl"
#include "lib/packet.cl"
#include "lib/surfel_packet.cl"
#include "shared/light.h"

/// From the sample to the surfels; infinitely far light: its direction.
static inline void sample_to_surfels(const SurfelPacket *s, global const LightSample *sample, vfloat *vx, vfloat *vy, vfloat *vz) {
    float4 p = sample->position;
    bool far = PENCIL_FAR_LIGHT && p.w == LIGHT_INFINITE;
    *vx = far ? (vfloat)(p.x) : s->x - p.x;
    *vy = far ? (vfloat)(p.y) : s->y - p.y;
    *vz = far ? (vfloat)(p.z) : s->z - p.z;
}

/// Share of its intensity that a spot sends along directions of this cosine to its axis: it falls linearly in the angle (Mitsuba).
static inline vfloat spot_share(global const LightSample *spot, vfloat cosine) {
    float end = spot->emission.w, beam = spot->normal.w;
    vfloat angle = acos(clamp(cosine, (vfloat)(-1.0f), (vfloat)(1.0f)));
    return clamp((end - angle) / fmax(end - beam, 1e-6f), (vfloat)(0.0f), (vfloat)(1.0f));
}

/// Geometry term of the sample for each surfel, with one division for all of it; 0 where they do not face each other. (vx, vy, vz): as
/// sample_to_surfels; tables: of profiles.
static inline vfloat sample_weight(const SurfelPacket *s, global const LightSample *sample, vfloat vx, vfloat vy, vfloat vz,
                                   global const half *tables) {
    float4 normal = sample->normal;
    float form = sample->position.w;
    if (PENCIL_FAR_LIGHT && form == LIGHT_INFINITE) return packet_cosine_towards(s, vx, vy, vz);
    bool area = form == LIGHT_AREA;
    vfloat weight = packet_cosine_towards(s, vx, vy, vz);
    vfloat rr = fma(vx, vx, fma(vy, vy, vz * vz));
    if (area) weight *= fmax(fma((vfloat)(normal.x), vx, fma((vfloat)(normal.y), vy, normal.z * vz)), (vfloat)(0.0f));
    if (PENCIL_FAR_LIGHT && form == LIGHT_SPOT) {
        vfloat inverse = packet_rsqrt(rr);
        weight *= spot_share(sample, fma((vfloat)(normal.x), vx, fma((vfloat)(normal.y), vy, normal.z * vz)) * inverse);
        normal.w = 0.0f;
    }
    if (PENCIL_FAR_LIGHT && form == LIGHT_PROFILE) {
        vfloat inverse = packet_rsqrt(rr);
        float share[PENCIL_WIDTH];
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l)
            share[l] = profile_share(tables, (int)sample->emission.w, normal.xyz,
                                     (float3)(LANE_FLOAT(vx, l), LANE_FLOAT(vy, l), LANE_FLOAT(vz, l)) * LANE_FLOAT(inverse, l));
        weight *= PACKET_LOAD(share);
    }
    vint faces = PACKET_MASK(weight > 0.0f);
    return select((vfloat)(0.0f), weight / ((area ? rr : rr * packet_rsqrt(rr)) * (rr + normal.w)), faces);
}
