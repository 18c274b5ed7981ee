// What the comparison maps share: paraboloid.cl, cube.cl, pyramid.cl, superquadric.cl store a sphere in several tiles of n x n texels with
// gutters, one after the other in one buffer (shared/atlas.h): a column of tiles in one image of width n + 2.
// The renderer uses the octahedral map; these exist to be compared with it (thesis 6.3.1). Every map has the functions
//   <map>_to_direction(u, v, tile)            direction through a point of a tile; its length is not 1
//   <map>_stored_direction(texel, tile, n)    what a texel holds, gutter included: filled this way, bilinear look-ups pass the seams
//   <map>_solid_angle_density(u, v, tile)     steradians per unit of (u, v) area; 0 where a tile holds nothing of its own
//   <map>_footprint(vx, vy, vz, n)            the 2 x 2 texels of packets of directions, index counted from the first tile

#include "lib/footprint.cl"
#include "lib/packet.cl"
#include "shared/atlas.h"

/// Centre of a texel in [-1, 1], along one side.
static inline float tile_coordinate(int texel, int n) { return (2 * texel + 1) / (float)n - 1.0f; }

/// Footprint at (u, v) in [-1, 1]^2 of a tile per lane.
static inline Footprint tile_footprint(vfloat u, vfloat v, vint tile, int n) {
    vfloat half_n = (vfloat)(0.5f * n), centre = (vfloat)(0.5f * n + 0.5f);  // counted from the first gutter texel's centre
    vfloat x = fma(u, half_n, centre), y = fma(v, half_n, centre);
    Footprint f;
    f.x = PACKET_TO_INT(x);  // x, y > 0: truncation is floor
    f.y = PACKET_TO_INT(y);
    f.index = tile * PENCIL_TILE_TEXELS(n) + f.y * PENCIL_TILE_STRIDE(n) + f.x;
    f.fx = x - PACKET_TO_FLOAT(f.x);
    f.fy = y - PACKET_TO_FLOAT(f.y);
    return f;
}

/// Tile of a dual map, per lane: 0 is the hemisphere z >= 0, 1 the other.
static inline vint dual_tile(vfloat vz) { return PACKET_MASK(vz < 0.0f) & 1; }
