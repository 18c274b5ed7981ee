// Quadrature weights by cells of directions (cells.cl): the weight w_i cos_i of a pencil is the cosine-weighted solid angle of the directions
// that are nearer to its own than to that of any other pencil which the surfel sees. No visibility masks are needed. With
// PENCIL_WEIGHTS_POWER rays of the surfels stand beside the pencils.

#include "lib/atlas.cl"
#include "lib/cells.cl"
#include "lib/far_end.cl"
#include "lib/footprint.cl"
#include "lib/map.cl"
#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/projection.cl"
#include "lib/surfel_packet.cl"
#include "lib/surfel_rays.cl"
#include "lib/visibility.cl"
#include "shared/atlas.h"
#include "shared/weights.h"

/// Pencils whose visibility is kept at once, and pencils whose weights are.
#define CELL_CHUNK 128

/// Pencils `first` to `last` of `count`.
typedef struct PencilChunk {
    global const float4 *cops;
    int count, first, last;
} PencilChunk;

/// Radius of the cell of pencil i: 0 for plain cells, which need none.
static inline vfloat pencil_radius(const SurfelPacket *s, const VisibilityMap *map, RADIANCE_ATLAS radiance, const PencilChunk *pencils,
                                   int i, const Aimed *aimed, int lanes, const SurfelRays *rays) {
#if PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER
    float4 cop = (float4)(pencils->cops[i].xyz, 0.0f), light[PENCIL_WIDTH];
    float beyond[PENCIL_WIDTH];
    far_ends(s, map, radiance, i, &aimed->f, cop, lanes, light);
    for (int l = 0; l < PENCIL_WIDTH; ++l) beyond[l] = lanes >> l & 1 ? light[l].w : 0.0f;
    vfloat vx = cop.x - s->x, vy = cop.y - s->y, vz = cop.z - s->z;
    vfloat path = sqrt(fma(vx, vx, fma(vy, vy, vz * vz))) + PACKET_LOAD(beyond);
    return cell_radius(FREE_PATH_DENSITY(path, rays->volume), aimed->weight, pencils->count, rays->count);
#else
    return 0.0f;
#endif
}

/// Offers pencils to the cells of a block.
static inline void offer_chunk(const SurfelPacket *packets, const VisibilityMap *map, RADIANCE_ATLAS radiance, const PencilChunk *pencils,
                               const CellDirections *directions, const SurfelRays *rays, Cells *cells, ProjectionSums *sums) {
    int lanes[CELL_CHUNK][PENCIL_BLOCK];
    vfloat radii[PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER ? CELL_CHUNK : 1][PENCIL_BLOCK];
    const int kept = PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER ? CELL_CHUNK : 1;
    for (int i = pencils->first; i < pencils->last; ++i) {
        float4 cop = (float4)(pencils->cops[i].xyz, 0.0f);
        Aimed aimed[PENCIL_BLOCK];
        for (int p = 0; p < PENCIL_BLOCK; ++p) aim_at_pencil(packets + p, map, cop, i, aimed + p);
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            int seen = packet_visible(packets + p, map, aimed + p, i, cop);
            lanes[i - pencils->first][p] = seen;
            if (!seen) continue;
            sums->seen[p] -= PACKET_FROM_BITS(seen);
            vfloat radius = pencil_radius(packets + p, map, radiance, pencils, i, aimed + p, seen, rays);
            radii[(i - pencils->first) % kept][p] = radius;
            Site site = cell_site(packets + p, cells + p, cop, seen, radius);
            approach_cells(directions, &site, cells + p);
        }
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        limit_cells(directions, cells + p);
        for (int i = pencils->first; i < pencils->last; ++i) {
            int seen = lanes[i - pencils->first][p];
            if (!seen) continue;
            vfloat radius = PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER ? radii[(i - pencils->first) % kept][p] : (vfloat)(0.0f);
            Site site = cell_site(packets + p, cells + p, (float4)(pencils->cops[i].xyz, 0.0f), seen, radius);
            offer_site(directions, &site, i, cells + p);
        }
    }
}

/// Adds what `lanes`, bits per packet of a block, receive from the far ends of their lines through pencil i.
static inline void add_far_ends(const SurfelPacket *packets, const VisibilityMap *map, RADIANCE_ATLAS radiance, int i, float4 cop,
                                const Aimed *aimed, const int *lanes, ProjectionSums *sums) {
    float4 light[PENCIL_WIDTH];
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        if (!lanes[p]) continue;
        far_ends(packets + p, map, radiance, i, &aimed[p].f, cop, lanes[p], light);
        for (int rest = lanes[p]; rest; rest &= rest - 1) {
            int l = LOWEST_LANE(rest);
            sums->light[p * PENCIL_WIDTH + l] += LANE_FLOAT(aimed[p].weight, l) * (float4)(light[l].xyz, 1.0f);
        }
    }
}

/// Adds pencils with the number of directions that they are nearest to.
static inline void add_chunk(const SurfelPacket *packets, const VisibilityMap *map, RADIANCE_ATLAS radiance, const PencilChunk *pencils,
                             const CellDirections *directions, const Cells *cells, ProjectionSums *sums) {
    const int samples = directions->tiles * PENCIL_CELL_TILE, numbers = directions->numbers, first = pencils->first;
    ushort won[CELL_CHUNK * PENCIL_BLOCK * PENCIL_WIDTH];  // [pencil][packet][lane]
    for (int k = 0; k < CELL_CHUNK * PENCIL_BLOCK * PENCIL_WIDTH; ++k) won[k] = 0;
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        for (int k = 0; k < samples; ++k) {
            vint owner = (cells[p].nearest[k] & numbers) - first;
            for (int l = 0; l < PENCIL_WIDTH; ++l) {
                uint i = (uint)LANE_INT(owner, l);
                if (i < (uint)(pencils->last - first)) ++won[(i * PENCIL_BLOCK + p) * PENCIL_WIDTH + l];
            }
        }
    for (int i = first; i < pencils->last; ++i) {
        float4 cop = (float4)(pencils->cops[i].xyz, 0.0f);
        Aimed aimed[PENCIL_BLOCK];
        int lanes[PENCIL_BLOCK];
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            vint count = PACKET_LOAD_USHORT(won + ((i - first) * PENCIL_BLOCK + p) * PENCIL_WIDTH);
            lanes[p] = PACKET_BITS(PACKET_MASK(count > 0));
            if (!lanes[p]) continue;
            aimed[p].weight = PACKET_TO_FLOAT(count);
            aimed[p].f = map_footprint_in(i, packets[p].x - cop.x, packets[p].y - cop.y, packets[p].z - cop.z, map->n);
            prefetch_radiance(&aimed[p].f, radiance, map->n);
        }
        if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER)
            add_far_ends(packets, map, radiance, i, cop, aimed, lanes, sums);
        else
            add_lanes(aimed, lanes, radiance, i, map->n, sums);
    }
}

/// Adds every pencil that the block sees with the number of directions in its cell, and the rays. `tiles`: of the table of directions.
static inline void sum_pencils(const SurfelPacket *packets, const VisibilityMap *map, RADIANCE_ATLAS radiance, global const float4 *cops,
                               int pencil_count, global const float4 *directions, int tiles, const SurfelRays *rays, ProjectionSums *sums) {
    Cells cells[PENCIL_BLOCK];
    int numbers = (int)(0xffffffffu >> clz(pencil_count + rays->count));  // all ones is no site's number
    CellDirections table = {directions, directions + tiles, tiles, numbers};
    for (int p = 0; p < PENCIL_BLOCK; ++p) begin_cells(packets + p, &table, rays->count, cells + p);
    if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER) offer_rays(rays, pencil_count, &table, cells);
    for (int first = 0; first < pencil_count; first += CELL_CHUNK) {
        PencilChunk chunk = {cops, pencil_count, first, min(first + CELL_CHUNK, pencil_count)};
        offer_chunk(packets, map, radiance, &chunk, &table, rays, cells, sums);
    }
    for (int first = 0; first < pencil_count; first += CELL_CHUNK) {
        PencilChunk chunk = {cops, pencil_count, first, min(first + CELL_CHUNK, pencil_count)};
        add_chunk(packets, map, radiance, &chunk, &table, cells, sums);
    }
    if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER) add_rays(rays, pencil_count, &table, cells, sums);
}
