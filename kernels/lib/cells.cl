// Cells of directions over the hemisphere of a packet of surfels: which of many sites, directions in which light is known, is the nearest.
// The cosine-weighted solid angle of its cell is the weight of a site.
//
// Cells are sampled. Up to PENCIL_CELL_GRID^2 directions of equal cosine-weighted solid angle, the same in the frame of every surfel, each
// take the nearest site. Directions come in tiles of PENCIL_CELL_TILE neighbours. Only sites that may be the nearest to some direction of a
// tile are compared with all of them, which most are not.
//
// PENCIL_WEIGHTS_VORONOI: the distance is 1 - cos. PENCIL_WEIGHTS_POWER: less the site's radius (balance.cl), so that cells are those of a
// power diagram (Aurenhammer 1987) and not half of them reach from where sites crowd to where they are rare.

#include "lib/balance.cl"
#include "lib/packet.cl"
#include "lib/surfel_packet.cl"
#include "shared/weights.h"

#if PENCIL_CELL_GRID > 0  // where weights are cells

#define CELL_SAMPLES (PENCIL_CELL_GRID * PENCIL_CELL_GRID)
#define CELL_TILES (CELL_SAMPLES / PENCIL_CELL_TILE)
/// Distances are at most 2 and CELL_OFFSET. Below the horizon of a lane lies what it does not see, farther than anything.
#define CELL_NONE 8.0f
#define CELL_UNSEEN (-1e6f)
/// Keeps distances positive whatever rounding does and radii are, so that they are ordered as their bits are. No more than that: the lowest bits
/// of distances hold numbers of sites.
#if PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER
#define CELL_OFFSET(rays) (1.0f + 4e-6f + 0.5f * MOST_CELLS / (rays))
#else
#define CELL_OFFSET(rays) (1.0f + 4e-6f)
#endif
/// Rounding error of cosines.
#if PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER
#define CELL_SLACK 1e-3f  // bounds of tiles take roots of them
#else
#define CELL_SLACK 1e-5f
#endif

/// The cells of one packet.
typedef struct Cells {
    vfloat tx, ty, tz, bx, by, bz;  // tangents of the surfels
    vint nearest[CELL_SAMPLES];     // bits of the distance to the nearest site, its number in the lowest of them
    float offset;                   // CELL_OFFSET
    vfloat centre[CELL_TILES];      // what is known of the distance to the nearest site: approach_cells
    vfloat reach[CELL_TILES];       // sites farther from a tile than this are not the nearest to any of its directions
} Cells;

/// A table of directions: the axes of the tiles, w: cosine of twice the greatest angle between axis and directions; then the directions.
typedef struct CellDirections {
    global const float4 *axes, *samples;
    int tiles, numbers;  // number of tiles; mask of the bits that hold numbers of sites
} CellDirections;

/// A direction in the frames of a packet of surfels.
typedef struct Site {
    vfloat x, y, z;
    vfloat offset;  // of distances: Cells::offset less the radius
} Site;

static inline vfloat site_distance(float4 direction, const Site *s) {
    return fma(s->x, (vfloat)(-direction.x), fma(s->y, (vfloat)(-direction.y), fma(s->z, (vfloat)(-direction.z), s->offset)));
}

/// Tangents without a branch that jumps (Duff et al. 2017); nothing near yet.
static inline void begin_cells(const SurfelPacket *s, const CellDirections *directions, int rays, Cells *cells) {
    cells->offset = CELL_OFFSET(rays);
    vfloat side = copysign((vfloat)(1.0f), s->nz), k = -1.0f / (side + s->nz), m = s->nx * s->ny * k;
    cells->tx = fma(side * s->nx * s->nx, k, (vfloat)(1.0f));
    cells->ty = side * m;
    cells->tz = -side * s->nx;
    cells->bx = m;
    cells->by = fma(s->ny * s->ny, k, side);
    cells->bz = -s->ny;
    int samples = directions->tiles * PENCIL_CELL_TILE;
    for (int i = 0; i < samples; ++i) cells->nearest[i] = as_int(CELL_NONE) | directions->numbers;
    for (int g = 0; g < directions->tiles; ++g) cells->centre[g] = CELL_NONE;
}

/// Unit direction to `cop`; far below the horizon for all but `lanes`.
static inline Site cell_site(const SurfelPacket *s, const Cells *cells, float4 cop, int lanes, vfloat radius) {
    vfloat vx = cop.x - s->x, vy = cop.y - s->y, vz = cop.z - s->z;
    vint seen = PACKET_FROM_BITS(lanes);
    vfloat scale = select((vfloat)(0.0f), packet_rsqrt(fma(vx, vx, fma(vy, vy, vz * vz))), seen);
    Site site;
    site.x = scale * fma(cells->tx, vx, fma(cells->ty, vy, cells->tz * vz));
    site.y = scale * fma(cells->bx, vx, fma(cells->by, vy, cells->bz * vz));
    site.z = select((vfloat)(CELL_UNSEEN), scale * fma(s->nx, vx, fma(s->ny, vy, s->nz * vz)), seen);
    site.offset = cells->offset - radius;
    return site;
}

/// Cosine of the greatest angle between the axis of a tile and its directions.
static inline float tile_cosine(float4 axis) { return sqrt(0.5f * (1.0f + axis.w)); }

/// Bound of the distances of a site from the directions of a tile, from above (`farthest`) or below.
static inline vfloat tile_distance(float4 axis, const Site *site, bool farthest) {
    float alpha = tile_cosine(axis);
    vfloat c = site->offset - site_distance(axis, site);
    vfloat across = sqrt(fmax(fma(-c, c, (vfloat)(1.0f)), (vfloat)(0.0f))) * sqrt(1.0f - alpha * alpha);
    if (farthest) return site->offset - fma(c, (vfloat)(alpha), -across);
    return site->offset - select(fma(c, (vfloat)(alpha), across), (vfloat)(1.0f), PACKET_MASK(c >= alpha));
}

/// Tells the tiles how near a site is. `centre` becomes the distance of the tile's axis to the nearest; of power cells what the distance of
/// every direction of the tile to its nearest is not above.
static inline void approach_cells(const CellDirections *directions, const Site *site, Cells *cells) {
    for (int g = 0; g < directions->tiles; ++g) {
        float4 axis = directions->axes[g];
        vfloat distance = PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER ? tile_distance(axis, site, true) : site_distance(axis, site);
        cells->centre[g] = PACKET_MIN(cells->centre[g], distance);
    }
}

/// How far sites may be from a tile to matter. Plain cells: any direction of the tile is within alpha of the axis, so it has a site within
/// theta + alpha, theta the angle from the axis to its nearest; nearer ones are within theta + 2 alpha of the axis.
static inline void limit_cells(const CellDirections *directions, Cells *cells) {
    for (int g = 0; g < directions->tiles; ++g) {
        vfloat h = cells->centre[g];
        if (PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER) {
            cells->reach[g] = h + CELL_SLACK;
            continue;
        }
        float c = directions->axes[g].w, s = sqrt(1.0f - c * c);
        vfloat cosine = 1.0f - h, sine = sqrt(fmax(h * (2.0f - h), (vfloat)(0.0f)));
        vfloat reach = fma(sine, (vfloat)(s), fma(cosine, (vfloat)(-c), (vfloat)(1.0f + CELL_SLACK)));
        cells->reach[g] = select(reach, (vfloat)(CELL_NONE), PACKET_MASK(cosine <= -c));
    }
}

/// Offers a site, of number i, to all directions. Needs limit_cells, with this site among those that approached.
static inline void offer_site(const CellDirections *directions, const Site *site, int i, Cells *cells) {
    const int tiles = directions->tiles, numbers = directions->numbers;
    for (int g = 0; g < tiles; ++g) {
        float4 axis = directions->axes[g];
        vfloat distance = PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER ? tile_distance(axis, site, false) : site_distance(axis, site);
        if (!PACKET_ANY(PACKET_MASK(distance <= cells->reach[g]))) continue;
        global const float4 *samples = directions->samples + g * PENCIL_CELL_TILE;
        vint *nearest = cells->nearest + g * PENCIL_CELL_TILE;
#pragma unroll
        for (int k = 0; k < PENCIL_CELL_TILE; ++k) {
            vint bits = (PACKET_AS_INT(site_distance(samples[k], site)) & ~numbers) | i;
            nearest[k] = min(nearest[k], bits);
        }
    }
}

#endif
