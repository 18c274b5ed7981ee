// Radiance maps as projection looks them up: the atlas buffer (shared/atlas.h), or with PENCIL_ATLAS_IMAGE a copy of it with a tile in each
// layer of an image, which the device filters. Gutters are part of both, so look-ups never leave a tile.

#include "lib/footprint.cl"
#include "lib/map.cl"
#include "lib/packet.cl"
#include "shared/atlas.h"

#ifndef PENCIL_ATLAS_IMAGE
#error PENCIL_ATLAS_IMAGE is not defined: 0 or 1
#endif

#if PENCIL_ATLAS_IMAGE
#define RADIANCE_ATLAS read_only image2d_array_t
constant sampler_t atlas_sampler = CLK_NORMALIZED_COORDS_FALSE | CLK_ADDRESS_CLAMP_TO_EDGE | CLK_FILTER_LINEAR;
#else
#define RADIANCE_ATLAS global const float4 *
#endif

/// Asks for the texels of a packet's footprints, index from the first texel of all tiles.
static inline void prefetch_radiance(const Footprint *f, RADIANCE_ATLAS radiance, int n) {
#if PENCIL_ATLAS_IMAGE
    (void)f;  // caches of images are the device's own
    (void)radiance;
    (void)n;
#else
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; l += 2) {
        global const float4 *texel = radiance + LANE_INT(f->index, l);
        PREFETCH(texel);
        PREFETCH(texel + PENCIL_TILE_STRIDE(n));
    }
#endif
}

/// Radiance (rgb) and density weight 1/D (w) of lane l of footprints in `tile`, by bilinear interpolation; `stride` of the tile. DEVIATION: 1/D is interpolated, not D:
/// it is what is used. Devices may round the interpolation weights of images to 8 bits: docs/conventions.md has the bound.
static inline float4 fetch_radiance(RADIANCE_ATLAS radiance, int tile, const Footprint *f, uint l, int stride) {
    float fx = LANE_FLOAT(f->fx, l), fy = LANE_FLOAT(f->fy, l);
#if PENCIL_ATLAS_IMAGE
    (void)stride;
    // The centre of texel (x, y) is at (x + 1/2, y + 1/2).
    float4 place = (float4)(LANE_INT(f->x, l) + 0.5f + fx, LANE_INT(f->y, l) + 0.5f + fy, tile, 0.0f);
    return read_imagef(radiance, atlas_sampler, place);
#else
    (void)tile;
    // Two texels of a row are loaded at once.
    global const float *texel = (global const float *)(radiance + LANE_INT(f->index, l));
    float8 upper = vload8(0, texel), lower = vload8(0, texel + 4 * stride);
    float8 row = upper + fy * (lower - upper);
    return row.lo + fx * (row.hi - row.lo);
#endif
}

/// One texel of a tile.
static inline float4 radiance_texel(RADIANCE_ATLAS radiance, int tile, int2 texel, int n) {
#if PENCIL_ATLAS_IMAGE
    (void)n;
    return read_imagef(radiance, (int4)(texel + PENCIL_GUTTER, tile, 0));
#else
    return radiance[map_atlas_index(tile, texel, n)];
#endif
}
