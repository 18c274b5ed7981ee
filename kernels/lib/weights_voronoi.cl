// Quadrature weights by hemispherical Voronoi cells: the weight w_i cos_i of a pencil is the cosine-weighted solid angle of the directions
// that are nearer to its own than to that of any other pencil which the surfel sees. No density is needed.
//
// Cells are sampled. Up to PENCIL_CELL_GRID^2 directions of equal cosine-weighted solid angle, the same in the frame of every surfel, each
// take the nearest pencil; what a pencil has got is its weight. Directions come in tiles of PENCIL_CELL_TILE neighbours. Only pencils that
// may be the nearest to some direction of a tile are compared with all of them, which most are not.

#include "lib/footprint.cl"
#include "lib/packet.cl"
#include "lib/packet_visibility.cl"
#include "lib/projection.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"
#include "shared/atlas.h"
#include "shared/weights.h"

#define CELL_SAMPLES (PENCIL_CELL_GRID * PENCIL_CELL_GRID)
#define CELL_TILES (CELL_SAMPLES / PENCIL_CELL_TILE)
/// Pencils whose visibility is kept at once, and pencils whose weights are.
#define CELL_CHUNK 128
/// Distances 1 - cos of unit directions are at most 2. Below the horizon of a lane lies what it does not see, farther than anything.
#define CELL_NONE 4.0f
#define CELL_UNSEEN (-1e6f)
/// Keeps distances positive whatever rounding does, so that they are ordered as their bits are.
#define CELL_OFFSET (1.0f + 4e-6f)
/// Rounding error of cosines.
#define CELL_SLACK 1e-5f

/// The cells of one packet. Distances are 1 - cos.
typedef struct Cells {
    vfloat tx, ty, tz, bx, by, bz;  // tangents of the surfels
    vint nearest[CELL_SAMPLES];     // bits of the distance to the nearest pencil, its number in the lowest of them
    vfloat centre[CELL_TILES];      // distance of the tile's axis to the nearest pencil
    vfloat reach[CELL_TILES];       // pencils farther from the axis than this are not the nearest to any direction of the tile
} Cells;

/// A table of directions: the axes of the tiles, w: cosine of twice the greatest angle between axis and directions; then the directions.
typedef struct CellDirections {
    global const float4 *axes, *samples;
    int tiles, numbers;  // number of tiles; mask of the bits that hold numbers of pencils
} CellDirections;

static inline vfloat cell_distance(float4 direction, vfloat x, vfloat y, vfloat z) {
    return fma(x, (vfloat)(-direction.x), fma(y, (vfloat)(-direction.y), fma(z, (vfloat)(-direction.z), (vfloat)(CELL_OFFSET))));
}

/// Tangents without a branch that jumps (Duff et al. 2017); nothing near yet.
static inline void begin_cells(const SurfelPacket *s, const CellDirections *directions, Cells *cells) {
    vfloat side = copysign((vfloat)(1.0f), s->nz), k = -1.0f / (side + s->nz), m = s->nx * s->ny * k;
    cells->tx = fma(side * s->nx * s->nx, k, (vfloat)(1.0f));
    cells->ty = side * m;
    cells->tz = -side * s->nx;
    cells->bx = m;
    cells->by = fma(s->ny * s->ny, k, side);
    cells->bz = -s->ny;
    int samples = directions->tiles * PENCIL_CELL_TILE;
    for (int k = 0; k < samples; ++k) cells->nearest[k] = as_int(CELL_NONE) | directions->numbers;
    for (int g = 0; g < directions->tiles; ++g) cells->centre[g] = CELL_NONE;
}

/// Unit direction to `cop` in the frames of the surfels; far below the horizon for all but `lanes`.
static inline void cell_direction(const SurfelPacket *s, const Cells *cells, float4 cop, int lanes, vfloat *x, vfloat *y, vfloat *z) {
    vfloat vx = cop.x - s->x, vy = cop.y - s->y, vz = cop.z - s->z;
    vint seen = PACKET_FROM_BITS(lanes);
    vfloat scale = select((vfloat)(0.0f), packet_rsqrt(fma(vx, vx, fma(vy, vy, vz * vz))), seen);
    *x = scale * fma(cells->tx, vx, fma(cells->ty, vy, cells->tz * vz));
    *y = scale * fma(cells->bx, vx, fma(cells->by, vy, cells->bz * vz));
    *z = select((vfloat)(CELL_UNSEEN), scale * fma(s->nx, vx, fma(s->ny, vy, s->nz * vz)), seen);
}

/// How far pencils may be from the axis of a tile to matter: any direction of the tile is within alpha of the axis, so it has a pencil
/// within theta + alpha, theta the angle from the axis to its nearest; nearer ones are within theta + 2 alpha of the axis.
static inline void limit_cells(const CellDirections *directions, Cells *cells) {
    for (int g = 0; g < directions->tiles; ++g) {
        float c = directions->axes[g].w, s = sqrt(1.0f - c * c);
        vfloat h = cells->centre[g], cosine = 1.0f - h;
        vfloat sine = sqrt(fmax(h * (2.0f - h), (vfloat)(0.0f)));
        vfloat reach = fma(sine, (vfloat)(s), fma(cosine, (vfloat)(-c), (vfloat)(1.0f + CELL_SLACK)));
        cells->reach[g] = select(reach, (vfloat)(CELL_NONE), PACKET_MASK(cosine <= -c));
    }
}

/// Offers pencil i, in direction (x, y, z), to all directions.
static inline void offer_pencil(const CellDirections *directions, vfloat x, vfloat y, vfloat z, int i, Cells *cells) {
    global const float4 *axes = directions->axes;
    const int tiles = directions->tiles, numbers = directions->numbers;
    for (int g = 0; g < tiles; ++g) {
        if (!PACKET_ANY(PACKET_MASK(cell_distance(axes[g], x, y, z) <= cells->reach[g]))) continue;
        global const float4 *samples = directions->samples + g * PENCIL_CELL_TILE;
        vint *nearest = cells->nearest + g * PENCIL_CELL_TILE;
#pragma unroll
        for (int k = 0; k < PENCIL_CELL_TILE; ++k) {
            vint bits = (PACKET_AS_INT(cell_distance(samples[k], x, y, z)) & ~numbers) | i;
            nearest[k] = min(nearest[k], bits);
        }
    }
}

/// Offers the pencils `first` to `last` to the cells of a block.
static inline void offer_chunk(const SurfelPacket *packets, const VisibilityMap *map, global const float4 *cops, int first, int last,
                        const CellDirections *directions, Cells *cells, ProjectionSums *sums) {
    int lanes[CELL_CHUNK][PENCIL_BLOCK];
    vfloat x, y, z;
    for (int i = first; i < last; ++i) {
        float4 cop = (float4)(cops[i].xyz, 0.0f);
        Aimed aimed[PENCIL_BLOCK];
        for (int p = 0; p < PENCIL_BLOCK; ++p) aim_at_pencil(packets + p, map, cop, i, aimed + p);
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            int seen = packet_visible(packets + p, map, aimed + p, i, cop);
            lanes[i - first][p] = seen;
            if (!seen) continue;
            sums->seen[p] -= PACKET_FROM_BITS(seen);
            cell_direction(packets + p, cells + p, cop, seen, &x, &y, &z);
            for (int g = 0; g < directions->tiles; ++g)
                cells[p].centre[g] = PACKET_MIN(cells[p].centre[g], cell_distance(directions->axes[g], x, y, z));
        }
    }
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        limit_cells(directions, cells + p);
        for (int i = first; i < last; ++i) {
            if (!lanes[i - first][p]) continue;
            cell_direction(packets + p, cells + p, (float4)(cops[i].xyz, 0.0f), lanes[i - first][p], &x, &y, &z);
            offer_pencil(directions, x, y, z, i, cells + p);
        }
    }
}

/// Adds the pencils `first` to `last` with the number of directions that they are nearest to.
static inline void add_chunk(const SurfelPacket *packets, const VisibilityMap *map, global const float4 *radiance, global const float4 *cops,
                      int first, int last, const CellDirections *directions, const Cells *cells, ProjectionSums *sums) {
    const int samples = directions->tiles * PENCIL_CELL_TILE, numbers = directions->numbers;
    ushort won[CELL_CHUNK * PENCIL_BLOCK * PENCIL_WIDTH];  // [pencil][packet][lane]
    for (int k = 0; k < CELL_CHUNK * PENCIL_BLOCK * PENCIL_WIDTH; ++k) won[k] = 0;
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        for (int k = 0; k < samples; ++k) {
            vint owner = (cells[p].nearest[k] & numbers) - first;
            for (int l = 0; l < PENCIL_WIDTH; ++l) {
                uint i = (uint)LANE_INT(owner, l);
                if (i < (uint)(last - first)) ++won[(i * PENCIL_BLOCK + p) * PENCIL_WIDTH + l];
            }
        }
    for (int i = first; i < last; ++i) {
        float4 cop = (float4)(cops[i].xyz, 0.0f);
        Aimed aimed[PENCIL_BLOCK];
        int lanes[PENCIL_BLOCK];
        for (int p = 0; p < PENCIL_BLOCK; ++p) {
            vint count = PACKET_LOAD_USHORT(won + ((i - first) * PENCIL_BLOCK + p) * PENCIL_WIDTH);
            lanes[p] = PACKET_BITS(PACKET_MASK(count > 0));
            if (!lanes[p]) continue;
            aimed[p].weight = PACKET_TO_FLOAT(count);
            aimed[p].f = packet_footprint(packets[p].x - cop.x, packets[p].y - cop.y, packets[p].z - cop.z, map->n);
            aimed[p].f.index += i * PENCIL_TILE_TEXELS(map->n);
            prefetch_radiance(aimed + p, radiance, map->n);
        }
        add_lanes(aimed, lanes, radiance, map->n, sums);
    }
}

/// Adds every pencil that the block sees with the number of directions in its cell. `tiles`: of the table of directions.
static inline void sum_pencils(const SurfelPacket *packets, const VisibilityMap *map, global const float4 *radiance, global const float4 *cops,
                        int pencil_count, global const float4 *directions, int tiles, ProjectionSums *sums) {
    Cells cells[PENCIL_BLOCK];
    int numbers = (int)(0xffffffffu >> clz(pencil_count));  // all ones is no pencil's number
    CellDirections table = {directions, directions + tiles, tiles, numbers};
    for (int p = 0; p < PENCIL_BLOCK; ++p) begin_cells(packets + p, &table, cells + p);
    for (int first = 0; first < pencil_count; first += CELL_CHUNK)
        offer_chunk(packets, map, cops, first, min(first + CELL_CHUNK, pencil_count), &table, cells, sums);
    for (int first = 0; first < pencil_count; first += CELL_CHUNK)
        add_chunk(packets, map, radiance, cops, first, min(first + CELL_CHUNK, pencil_count), &table, cells, sums);
}
