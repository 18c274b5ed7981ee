// What a light sample sends to packets of surfels (thesis alg. 6.2), visibility apart.
// DEVIATION: cos cos / r^2 becomes cos cos / (r^2 + A/pi), A the area the sample stands for: the form factor of a disc of that area, exact
// on its axis. It is bounded where r -> 0 and tends to the printed form as A does to 0. Point lights have A = 0 and cos_l = 1.

#include "lib/packet.cl"
#include "lib/surfel_packet.cl"
#include "shared/light.h"

/// Geometry term of the sample for each surfel, with one division for all of it; 0 where they do not face each other. (vx, vy, vz): from
/// the sample to the surfels.
static inline vfloat sample_weight(const SurfelPacket *s, global const LightSample *sample, vfloat vx, vfloat vy, vfloat vz) {
    float4 normal = sample->normal;
    bool area = sample->position.w != 0.0f;
    vfloat weight = packet_cosine_towards(s, vx, vy, vz);
    vfloat rr = fma(vx, vx, fma(vy, vy, vz * vz));
    if (area) weight *= fmax(fma((vfloat)(normal.x), vx, fma((vfloat)(normal.y), vy, normal.z * vz)), (vfloat)(0.0f));
    vint faces = PACKET_MASK(weight > 0.0f);
    return select((vfloat)(0.0f), weight / ((area ? rr : rr * packet_rsqrt(rr)) * (rr + normal.w)), faces);
}
