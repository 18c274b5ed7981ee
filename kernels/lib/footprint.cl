// The 2x2 bilinear footprint of packets of directions: the octahedral map. Those of other maps stand in their files.

#include "lib/packet.cl"
#include "shared/atlas.h"

/// Where a packet of directions falls in a tile: index of the footprint's first texel (gutter layout, relative to the tile) and the
/// bilinear weights of its second column and row.
typedef struct Footprint {
    vint index;
    vint x, y;  // of the first texel, counted from the gutter
    vfloat fx, fy;
} Footprint;

/// L1 norms below this are taken as this, so that a direction of zero length has a finite footprint.
#define FOOTPRINT_TINY 1e-30f

/// thesis eq. (4.25), listing 4.2 with its operands put right. DEVIATION: copysign, not SGN: the sign of 0 must not be 0 on the seam.
static inline Footprint packet_footprint(vfloat vx, vfloat vy, vfloat vz, int n) {
    vfloat norm = fmax(fabs(vx) + fabs(vy) + fabs(vz), (vfloat)(FOOTPRINT_TINY));
    vfloat scale = (0.5f * n) / norm;
    vfloat fold = fmax(-vz, (vfloat)(0.0f));
    vfloat centre = (vfloat)(0.5f * n + 0.5f);  // of the tile, counted from the first gutter texel's centre
    vfloat x = fma(vx + copysign(fold, vx), scale, centre);
    vfloat y = fma(vy + copysign(fold, vy), scale, centre);
    vint ix = PACKET_TO_INT(x);  // x, y > 0: truncation is floor
    vint iy = PACKET_TO_INT(y);
    Footprint f;
    f.x = ix;
    f.y = iy;
    f.index = iy * PENCIL_TILE_STRIDE(n) + ix;
    f.fx = x - PACKET_TO_FLOAT(ix);
    f.fy = y - PACKET_TO_FLOAT(iy);
    return f;
}

/// First texel of the footprint of lane l; -1 is the gutter.
static inline int2 footprint_corner(const Footprint *f, int l) { return (int2)(LANE_INT(f->x, l), LANE_INT(f->y, l)) - PENCIL_GUTTER; }
