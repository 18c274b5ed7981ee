// Projection R and scattering K: the radiance of a set of pencils, reflected by surfels (thesis eq. (5.23), alg. 6.3). The same kernel
// serves pencil transport (surfels of the next set's texels) and projection-scatter (surfels of the film): it is the hot loop. How much
// each pencil counts is said by lib/weights_density.cl or lib/weights_cells.cl, one of which is built in.

#include "lib/atlas.cl"
#include "lib/packet.cl"
#include "lib/projection.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"
#include "lib/weights.cl"
#include "shared/geometry.h"

/// launch : 1-D, one work-item per block of PENCIL_BLOCK packets of PENCIL_WIDTH surfels from first_surfel on, a multiple of blocks
/// in     : surfels of `capacity` (a multiple of PENCIL_BLOCK * PENCIL_WIDTH); cops[pencil_count]; radiance: an atlas (lib/atlas.cl), cells, groups, hits:
///          tiles of n x n of those pencils; directions: table of CellDirections with direction_tiles
///          tiles, where weights are cells; rays[ray_count][RAY_FIELDS][ray_capacity]: of the surfels from first_surfel on, and
///          volume, in which centres are uniform, for PENCIL_WEIGHTS_POWER only
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to if `accumulate`; visible[capacity]: number of pencils that each surfel sees
/// needs  : radiance and hits folded. A surfel that sees no pencil, and has no ray, receives nothing.
/// E = pi sum(L w) / sum(w), w = cos/D or the cosine-weighted solid angle of a cell. DEVIATION: eq. (5.33)'s normaliser does not tend to
/// the integral. PENCIL_WEIGHTS_THESIS: the printed form, E = 2 pi / n_v^2 * sum(D) * sum(L cos/D), n_v pencils visible.
kernel void project_pencils(global const float *surfels, int capacity, int first_surfel, int surfel_count, global const float4 *cops,
                            int pencil_count, RADIANCE_ATLAS radiance, global const int2 *cells, global const int4 *groups,
                            global const Hit *hits, global const Triangle *triangles, global const float4 *planes, int n,
                            global const float4 *directions, int direction_tiles, global const float *rays, int ray_capacity, int ray_count,
                            float volume, global float *outgoing, int accumulate, global int *visible) {
    int offset = get_global_id(0) * PENCIL_BLOCK * PENCIL_WIDTH, first = first_surfel + offset;
    if (first >= surfel_count) return;
    VisibilityMap map = {cells, groups, hits, triangles, planes, n};
    SurfelPacket packets[PENCIL_BLOCK];
    for (int p = 0; p < PENCIL_BLOCK; ++p) packets[p] = load_surfels(surfels, capacity, first + p * PENCIL_WIDTH);
    ProjectionSums sums;
    clear_sums(&sums);
    SurfelRays own = {rays, ray_capacity, ray_count, offset, volume};
    sum_pencils(packets, &map, radiance, cops, pencil_count, directions, direction_tiles, &own, &sums);
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        float r[PENCIL_WIDTH], g[PENCIL_WIDTH], b[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            float3 e = projected_irradiance(&sums, p * PENCIL_WIDTH + l);
            r[l] = e.x;
            g[l] = e.y;
            b[l] = e.z;
        }
        scatter_irradiance(surfels, capacity, first + p * PENCIL_WIDTH, PACKET_LOAD(r), PACKET_LOAD(g), PACKET_LOAD(b), outgoing,
                           accumulate);
        PACKET_STORE(sums.seen[p], visible + first + p * PENCIL_WIDTH);
    }
}
