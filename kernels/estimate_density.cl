// Directional pencil density of the texels of a pencil set: thesis eq. (5.32), alg. 6.1.

#include "lib/map.cl"
#include "lib/packet.cl"
#include "lib/surfel_packet.cl"
#include "shared/types.h"

/// Exponents run from 2^0 to 2^MAX_DOUBLINGS.
#define MAX_DOUBLINGS 9

/// Exponent for one pencil seen: measured for this estimator.
#define DENSITY_EXPONENT 5.0f

/// log2 of the exponent beta for a surfel that sees n_v pencils. DEVIATION: the thesis sets beta by hand; here it is
/// DENSITY_EXPONENT n_v^(1/3), the bandwidth law of spherical kernel estimates, rounded to a power of two.
static inline int density_doublings(int visible) {
    return clamp((int)rint(log2(DENSITY_EXPONENT * cbrt((float)max(visible, 1)))), 0, MAX_DOUBLINGS);
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels of tiles first_tile .. (surfel order of gather_surfels, a packet lies
///          in one tile)
/// in     : surfels; cops[pencil_count]; mask of test_visibility for the same set
/// out    : radiance, atlas layout, w of interior texels: 1 / D_p(x) in (0, 1]; D counts the pencil itself, so D >= 1
kernel void estimate_density(global const float *surfels, int capacity, int surfel_count, global const float4 *cops, int pencil_count,
                             global const uint *mask, int first_tile, int n, global float4 *radiance) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= surfel_count) return;
    SurfelPacket s = load_surfels(surfels, capacity, first);
    int tile = first_tile + first / MAP_TEXELS(n);
    int words = (pencil_count + WORD_BITS - 1) / WORD_BITS;
    int seen[PENCIL_WIDTH], doublings[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) seen[l] = 0;
    for (int word = 0; word < words; ++word)
        for (int l = 0; l < PENCIL_WIDTH; ++l) seen[l] += popcount(mask[(size_t)word * capacity + first + l]);
    int most = 0;
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        doublings[l] = density_doublings(seen[l]);
        most = max(most, doublings[l]);
    }
    vint steps = PACKET_LOAD(doublings);
    float4 own = cops[tile];
    vfloat px = own.x - s.x, py = own.y - s.y, pz = own.z - s.z;
    vfloat scale = rsqrt(fma(px, px, fma(py, py, pz * pz)));
    px *= scale;
    py *= scale;
    pz *= scale;
    vfloat density = 0.0f;
    for (int word = 0; word < words; ++word) {
        vuint bits = PACKET_LOAD(mask + (size_t)word * capacity + first);
        for (int i = WORD_BITS * word; i < min(WORD_BITS * word + WORD_BITS, pencil_count); ++i) {
            vint visible = PACKET_MASK(((bits >> (uint)(i % WORD_BITS)) & 1u) != 0u);
            if (i == tile || !PACKET_ANY(visible)) continue;
            float4 cop = cops[i];
            vfloat vx = cop.x - s.x, vy = cop.y - s.y, vz = cop.z - s.z;
            vfloat cosine = fma(px, vx, fma(py, vy, pz * vz)) * rsqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
            vfloat power = fmin(fmax(cosine, (vfloat)(0.0f)), (vfloat)(1.0f));
            for (int k = 0; k < most; ++k) power = select(power, power * power, PACKET_MASK(steps > k));
            density += select((vfloat)(0.0f), power, visible);
        }
    }
    float weight[PENCIL_WIDTH];
    vfloat reciprocal = 1.0f / (1.0f + density);
    PACKET_STORE(reciprocal, weight);
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int2 texel = map_surfel_texel((first + l) % MAP_TEXELS(n), n);
        radiance[map_atlas_index(tile, texel, n)].w = weight[l];
    }
}
