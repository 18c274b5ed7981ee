// Rays that surfels have sent themselves (project_rays.cl), as sites of cells.

#include "lib/cells.cl"
#include "lib/projection.cl"
#include "shared/weights.h"

#if PENCIL_CELL_GRID > 0  // where weights are cells

/// Ray `k` of packet `p` of a block.
static inline Site ray_site(const SurfelRays *rays, int k, int p) {
    global const float *r = rays->data + (size_t)k * RAY_FIELDS * rays->capacity + rays->first + p * PENCIL_WIDTH;
    vfloat radius = PACKET_LOAD(r + (size_t)RAY_RADIUS * rays->capacity);
    Site site;
    site.x = PACKET_LOAD(r + (size_t)RAY_TANGENT * rays->capacity);
    site.y = PACKET_LOAD(r + (size_t)RAY_BITANGENT * rays->capacity);
    vfloat z = sqrt(fmax(fma(-site.x, site.x, fma(-site.y, site.y, (vfloat)(1.0f))), (vfloat)(0.0f)));
    site.z = select((vfloat)(CELL_UNSEEN), z, PACKET_MASK(radius >= 0.0f));
    site.offset = CELL_OFFSET(rays->count) - fmax(radius, (vfloat)(0.0f));
    return site;
}

/// Offers the rays to the cells of a block, under the numbers from `number` on.
static inline void offer_rays(const SurfelRays *rays, int number, const CellDirections *directions, Cells *cells) {
    for (int p = 0; p < PENCIL_BLOCK; ++p) {
        for (int k = 0; k < rays->count; ++k) {
            Site site = ray_site(rays, k, p);
            approach_cells(directions, &site, cells + p);
        }
        limit_cells(directions, cells + p);
        for (int k = 0; k < rays->count; ++k) {
            Site site = ray_site(rays, k, p);
            offer_site(directions, &site, number + k, cells + p);
        }
    }
}

/// Adds the light of the rays with the number of directions that they are nearest to.
static inline void add_rays(const SurfelRays *rays, int number, const CellDirections *directions, const Cells *cells,
                            ProjectionSums *sums) {
    const int samples = directions->tiles * PENCIL_CELL_TILE, numbers = directions->numbers;
    const size_t step = rays->capacity;
    for (int p = 0; p < PENCIL_BLOCK; ++p)
        for (int i = 0; i < samples; ++i) {
            vint owner = (cells[p].nearest[i] & numbers) - number;
            for (int l = 0; l < PENCIL_WIDTH; ++l) {
                uint ray = (uint)LANE_INT(owner, l);
                if (ray >= (uint)rays->count) continue;
                global const float *r = rays->data + ray * RAY_FIELDS * step + rays->first + p * PENCIL_WIDTH + l;
                sums->light[p * PENCIL_WIDTH + l] += (float4)(r[RAY_R * step], r[RAY_G * step], r[RAY_B * step], 1.0f);
            }
        }
}

#endif
