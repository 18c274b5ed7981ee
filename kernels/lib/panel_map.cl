// A map of several panels as map.cl wants it: the functions that its kinds share, over those that panels.cl names, which PANEL chooses.

#include "lib/octahedral.cl"
#include "lib/panels.cl"
#include "shared/atlas.h"

#ifndef PANEL
#error PANEL(name) is not defined: the function `name` of a kind of map
#endif

/// The texel `step` from `texel`, up to two outside of its panel, or the one that shows what lies there.
static inline int2 panel_texel_beside(int2 texel, int2 step, int n) {
    return PANEL(fold_texel)(texel_in_panel(texel, n) + step, panel_of_texel(texel, n), n);
}

/// Texel `x` of row `row`, counted over all panels without their gutters.
static inline int2 panel_texel_of_row(int x, int row, int n) { return texel_of_panel((int2)(x, row % n), row / n, n); }

static inline bool panel_is_inner(int2 texel, int n) { return oct_is_inner(texel_in_panel(texel, n), n); }
static inline bool panel_starts_footprint(int2 texel, int n) { return oct_starts_footprint(texel_in_panel(texel, n), n); }

static inline float4 panel_texel_direction(int2 texel, int n) {
    int2 inside = texel_in_panel(texel, n);
    return PANEL(to_direction)(panel_coordinate(inside.x, n), panel_coordinate(inside.y, n), panel_of_texel(texel, n));
}

static inline float panel_texel_solid_angle(int2 texel, int n) {
    int2 inside = texel_in_panel(texel, n);
    return PANEL(solid_angle_density)(panel_coordinate(inside.x, n), panel_coordinate(inside.y, n), panel_of_texel(texel, n)) * 4.0f /
           ((float)n * n);
}

/// Panels of opposite directions are numbers 2 k and 2 k + 1, and turned by half a turn against each other.
static inline int2 panel_antipode(int2 texel, int n) {
    return texel_of_panel(n - 1 - texel_in_panel(texel, n), panel_of_texel(texel, n) ^ 1, n);
}

/// Panels are multiples of RAY_BLOCK wide, not of SURFEL_BLOCK: rays and surfels have the same order.
static inline int2 panel_block_texel(int i, int n) { return texel_of_panel(oct_block_texel(i % (n * n), n), i / (n * n), n); }
static inline int2 panel_surfel_texel(int i, int n) { return panel_block_texel(i, n); }

static inline Footprint panel_map_footprint(vfloat vx, vfloat vy, vfloat vz, int n) { return PANEL(footprint)(vx, vy, vz, n); }
