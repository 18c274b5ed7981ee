// The maps of pencils, all that kernels know of them: functions of the kind that PENCIL_MAP_KIND names, the only one that is compiled.
// A texel is (x, y) in a tile, gutters counted as -1 and so on (shared/atlas.h); directions have the length that their map gives
// them, which is 1 / disparity of a hit at the end of them.

#include "lib/footprint.cl"
#include "lib/octahedral.cl"
#include "lib/packet.cl"
#include "lib/panels.cl"
#include "shared/atlas.h"
#include "shared/map_kind.h"

#if PENCIL_MAP_KIND == PENCIL_MAP_OCTAHEDRAL
#define MAP(name) oct_##name
static inline Footprint oct_map_footprint(vfloat vx, vfloat vy, vfloat vz, int n) { return packet_footprint(vx, vy, vz, n); }
#else
#define MAP(name) panel_##name
#if PENCIL_MAP_KIND == PENCIL_MAP_PYRAMID
#include "lib/pyramid.cl"
#define PANEL(name) pyramid_##name
#elif PENCIL_MAP_KIND == PENCIL_MAP_CUBE
#include "lib/cube.cl"
#define PANEL(name) cube_##name
#elif PENCIL_MAP_KIND == PENCIL_MAP_PARABOLOID
#include "lib/paraboloid.cl"
#define PANEL(name) paraboloid_##name
#endif
#include "lib/panel_map.cl"
#endif

/// Texels of a tile whose panels are n x n, with gutters and without.
#define MAP_PANELS PENCIL_MAP_PANELS(PENCIL_MAP_KIND)
#define MAP_STORED(n) (MAP_PANELS * PENCIL_TILE_TEXELS(n))
#define MAP_TEXELS(n) (MAP_PANELS * (n) * (n))
/// Width of an octahedral map of as many texels, in terms of n: how fine a map is.
#define MAP_FINENESS (MAP_PANELS == 1 ? 1.0f : MAP_PANELS == 2 ? M_SQRT2_F : 2.44948974f)

/// Index of a texel, gutters included, in the atlas buffer.
static inline int map_atlas_index(int tile, int2 texel, int n) {
    return tile * MAP_STORED(n) + (texel.y + PENCIL_GUTTER) * PENCIL_TILE_STRIDE(n) + texel.x + PENCIL_GUTTER;
}

/// Where packets of directions fall, index from the first texel of the tile.
static inline Footprint map_footprint(vfloat vx, vfloat vy, vfloat vz, int n) { return MAP(map_footprint)(vx, vy, vz, n); }

/// The same of tile number `tile`, index from the first texel of all tiles.
static inline Footprint map_footprint_in(int tile, vfloat vx, vfloat vy, vfloat vz, int n) {
    Footprint f = map_footprint(vx, vy, vz, n);
    f.index += tile * MAP_STORED(n);
    return f;
}

/// Direction through the centre of a texel, and the solid angle about it that no other texel has [sr].
static inline float4 map_texel_direction(int2 texel, int n) { return MAP(texel_direction)(texel, n); }
static inline float map_texel_solid_angle(int2 texel, int n) { return MAP(texel_solid_angle)(texel, n); }

/// Texel of the opposite direction.
static inline int2 map_antipode(int2 texel, int n) { return MAP(antipode)(texel, n); }

/// The texel `step` (-2 to 2 a side) from `texel`, which may be in a gutter: across a seam the one that shows what lies there.
static inline int2 map_texel_beside(int2 texel, int2 step, int n) { return MAP(texel_beside)(texel, step, n); }

/// Texel k of the 2 x 2 of the footprint with first texel `corner`.
static inline int2 map_footprint_texel(int2 corner, int k, int n) { return map_texel_beside(corner, (int2)(k & 1, k >> 1), n); }

/// The 4 x 4 texels about a 2 x 2 footprint, row by row.
#define AROUND_WIDTH 4
#define AROUND_TEXELS (AROUND_WIDTH * AROUND_WIDTH)

/// Texel k of those about the footprint with first texel `corner`.
static inline int2 map_texel_around(int2 corner, int k, int n) {
    return map_texel_beside(corner, (int2)(k % AROUND_WIDTH, k / AROUND_WIDTH) - 1, n);
}

/// True if texel k of those about a footprint is one of its own.
static inline bool texel_is_inner(int k) {
    int x = k % AROUND_WIDTH, y = k / AROUND_WIDTH;
    return (x == 1 || x == 2) && (y == 1 || y == 2);
}

/// True if all eight neighbours of a texel lie in its panel; if a footprint may start at it.
static inline bool map_is_inner(int2 texel, int n) { return MAP(is_inner)(texel, n); }
static inline bool map_starts_footprint(int2 texel, int n) { return MAP(starts_footprint)(texel, n); }

/// Orders of the MAP_TEXELS(n) texels of a tile: rows; blocks of surfels; blocks of rays.
static inline int2 map_texel_of_row(int x, int row, int n) { return MAP(texel_of_row)(x, row, n); }
static inline int2 map_surfel_texel(int i, int n) { return MAP(surfel_texel)(i, n); }
static inline int2 map_block_texel(int i, int n) { return MAP(block_texel)(i, n); }
