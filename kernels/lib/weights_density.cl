// Quadrature weights cos/D, D a density of pencils per direction: the radiance maps hold 1/D of each texel in w (estimate_density.cl,
// free_path_density.cl).

#include "lib/atlas.cl"
#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/projection.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"

/// Adds every pencil that the block sees with the weight cos/D.
static inline void sum_pencils(const SurfelPacket *packets, const VisibilityMap *map, RADIANCE_ATLAS radiance, global const float4 *cops,
                               int pencil_count, global const float4 *directions, int tiles, const SurfelRays *rays, ProjectionSums *sums) {
    (void)directions;
    (void)tiles;
    (void)rays;
    for (int i = 0; i < pencil_count; ++i) {
        float4 cop = (float4)(cops[i].xyz, 0.0f);
        Aimed aimed[PENCIL_BLOCK];
        int lanes[PENCIL_BLOCK];
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            aim_at_pencil(packets + p, map, cop, i, aimed + p);
            if (aimed[p].faces) prefetch_radiance(&aimed[p].f, radiance, map->n);
        }
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            lanes[p] = packet_visible(packets + p, map, aimed + p, i, cop);
            sums->seen[p] -= PACKET_FROM_BITS(lanes[p]);
        }
        add_lanes(aimed, lanes, radiance, i, map->n, sums);
    }
}
