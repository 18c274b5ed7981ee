// What a block of surfels receives from pencils. Every form of weights (weights_*.cl) brings
//   void sum_pencils(packets, map, radiance, cops, pencil_count, directions, tiles, rays, sums)
// which adds all pencils to the sums, and says which with which weight.

#include "lib/atlas.cl"
#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"
#include "shared/atlas.h"
#include "shared/weights.h"

/// Sums over the pencils that the surfels of a block see.
typedef struct ProjectionSums {
    float4 light[PENCIL_BLOCK * PENCIL_WIDTH];   // rgb: sum of L times weight; w: sum of weights
    vint seen[PENCIL_BLOCK];                     // number of pencils
    float density[PENCIL_BLOCK * PENCIL_WIDTH];  // sum of D, for PENCIL_WEIGHTS_THESIS only
} ProjectionSums;

/// Rays that the surfels have sent themselves (RAY_FIELDS), for PENCIL_WEIGHTS_POWER only.
typedef struct SurfelRays {
    global const float *data;
    int capacity, count;  // surfels, rays of each
    int first;            // the first surfel of the block
    float volume;         // in which centres of pencils are uniform
} SurfelRays;

static inline void clear_sums(ProjectionSums *sums) {
    for (int l = 0; l < PENCIL_BLOCK * PENCIL_WIDTH; ++l) {
        sums->light[l] = (float4)(0.0f);
        sums->density[l] = 0.0f;
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p) sums->seen[p] = 0;
}

/// Aims one packet at pencil i, with the cosine at the surfel as its weight.
static inline void aim_at_pencil(const SurfelPacket *s, const VisibilityMap *map, float4 cop, int i, Aimed *aimed) {
    vfloat vx = s->x - cop.x, vy = s->y - cop.y, vz = s->z - cop.z;
    vfloat towards = packet_cosine_towards(s, vx, vy, vz);
    aimed->faces = PACKET_BITS(PACKET_MASK(towards > 0.0f));
    if (!aimed->faces) return;
    aim_packet(map, i, vx, vy, vz, aimed);
    aimed->weight = towards * packet_rsqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
}

/// Adds what surfel number `surfel` of the block receives along its aimed direction from the centre of `tile` to the sums.
static inline void add_seen(const Aimed *block, uint surfel, RADIANCE_ATLAS radiance, int tile, int stride, ProjectionSums *sums) {
    const Aimed *aimed = block + surfel / PENCIL_WIDTH;
    uint l = surfel % PENCIL_WIDTH;
    float4 texel = fetch_radiance(radiance, tile, &aimed->f, l, stride);
    float weight = LANE_FLOAT(aimed->weight, l);
    if (PENCIL_CELL_GRID == 0) weight *= texel.w;
    sums->light[surfel] += weight * (float4)(texel.xyz, 1.0f);
    if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_THESIS) sums->density[surfel] += 1.0f / texel.w;
}

/// Adds to the sums of a block what its `lanes`, bits per packet, receive from pencil `tile`, which they are aimed at: lists them, then fetches
/// what is on the list in one loop without branches.
static inline void add_lanes(const Aimed *aimed, const int *lanes, RADIANCE_ATLAS radiance, int tile, int n, ProjectionSums *sums) {
    int list[(PENCIL_BLOCK + 1) * PENCIL_WIDTH], count = 0;
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        packet_store_packed(p * PENCIL_WIDTH + PACKET_LANES, lanes[p], list + count);
        count += popcount(lanes[p]);
    }
    const int stride = PENCIL_TILE_STRIDE(n);
    // The remainder changes nothing, but is a constant where a block is one surfel, and private arrays can then be registers.
    for (int k = 0; k < count; ++k) add_seen(aimed, (uint)list[k] % (PENCIL_BLOCK * PENCIL_WIDTH), radiance, tile, stride, sums);
}

/// Irradiance from the sums of surfel l of the block: E = pi sum(L w) / sum(w), and the printed form E = 2 pi / n_v^2 sum(D) sum(L cos/D).
static inline float3 projected_irradiance(const ProjectionSums *sums, int l) {
    float4 light = sums->light[l];
    float seen = (float)LANE_INT(sums->seen, l);
    if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_THESIS)
        return seen > 0.0f ? light.xyz * (2.0f * M_PI_F * sums->density[l] / (seen * seen)) : (float3)(0.0f);
    return light.w > 0.0f ? light.xyz * (M_PI_F / light.w) : (float3)(0.0f);
}
