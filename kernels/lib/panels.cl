// What the maps of several squares share: paraboloid.cl, pyramid.cl, cube.cl, and superquadric.cl, which no render uses. The squares,
// panels of n x n texels, stand in a column with their gutters (shared/atlas.h). Every such map has the functions
//   <map>_to_direction(u, v, panel)            direction through a point of a panel; its length is not 1
//   <map>_stored_direction(texel, panel, n)    what a texel holds, gutter included: filled this way, bilinear look-ups pass the seams
//   <map>_solid_angle_density(u, v, panel)     steradians per unit of (u, v) area; 0 where a panel holds nothing of its own
//   <map>_footprint(vx, vy, vz, n)             the 2 x 2 texels of packets of directions
// and those that renders have
//   <map>_fold_texel(texel, panel, n)          the texel of the tile that shows what lies at `texel`, up to two texels outside of a panel

#include "lib/footprint.cl"
#include "lib/packet.cl"
#include "shared/atlas.h"

/// Centre of a texel in [-1, 1], along one side.
static inline float panel_coordinate(int texel, int n) { return (2 * texel + 1) / (float)n - 1.0f; }

/// Footprint at (u, v) in [-1, 1]^2 of a panel per lane.
static inline Footprint panel_footprint(vfloat u, vfloat v, vint panel, int n) {
    vfloat half_n = (vfloat)(0.5f * n), centre = (vfloat)(0.5f * n + 0.5f);  // counted from the first gutter texel's centre
    vfloat x = fma(u, half_n, centre), y = fma(v, half_n, centre);
    vint row = PACKET_TO_INT(y);  // x, y > 0: truncation is floor
    Footprint f;
    f.x = PACKET_TO_INT(x);
    f.y = panel * PENCIL_TILE_STRIDE(n) + row;
    f.index = f.y * PENCIL_TILE_STRIDE(n) + f.x;
    f.fx = x - PACKET_TO_FLOAT(f.x);
    f.fy = y - PACKET_TO_FLOAT(row);
    return f;
}

/// Panel of a dual map, per lane: 0 is the hemisphere z >= 0, 1 the other.
static inline vint dual_panel(vfloat vz) { return PACKET_MASK(vz < 0.0f) & 1; }

/// Panel of a texel of the tile, gutters included.
static inline int panel_of_texel(int2 texel, int n) { return (texel.y + PENCIL_GUTTER) / PENCIL_TILE_STRIDE(n); }

/// A texel of the tile counted from its panel's first, and back.
static inline int2 texel_in_panel(int2 texel, int n) { return texel - (int2)(0, panel_of_texel(texel, n) * PENCIL_TILE_STRIDE(n)); }
static inline int2 texel_of_panel(int2 texel, int panel, int n) { return texel + (int2)(0, panel * PENCIL_TILE_STRIDE(n)); }
