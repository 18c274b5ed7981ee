// Dual pyramid map, thesis eq. (4.12): tile 0 is the hemisphere z >= 0, tile 1 the other; a hemisphere fills the square. Linear in each of
// the four faces |v| <= |u|, |u| <= |v|.

#include "lib/footprint.cl"
#include "lib/map_tiles.cl"
#include "lib/packet.cl"

/// Direction through (u, v), inverse of eq. (4.12).
static inline float4 pyramid_to_direction(float u, float v, int tile) {
    float z = 1.0f - fmax(fabs(u), fabs(v));
    return (float4)(u, v, tile ? -z : z, 0.0f);
}

/// Gutter texels repeat the texel across the seam: the edge texel at the same place of the other tile; a corner crosses twice and repeats
/// the corner of its own tile. Bilinear look-ups are continuous across seams and corners.
static inline float4 pyramid_stored_direction(int2 texel, int tile, int n) {
    int2 inside = clamp(texel, (int2)(0), (int2)(n - 1));
    int crossings = (texel.x != inside.x) + (texel.y != inside.y);
    return pyramid_to_direction(tile_coordinate(inside.x, n), tile_coordinate(inside.y, n), (tile + crossings) & 1);
}

static inline float pyramid_solid_angle_density(float u, float v, int tile) {
    float4 d = pyramid_to_direction(u, v, tile);
    float r = length(d.xyz);
    return 1.0f / (r * r * r);
}

static inline Footprint pyramid_footprint(vfloat vx, vfloat vy, vfloat vz, int n) {
    vfloat scale = 1.0f / fmax(fabs(vz) + fmax(fabs(vx), fabs(vy)), (vfloat)(FOOTPRINT_TINY));
    return tile_footprint(vx * scale, vy * scale, dual_tile(vz), n);
}
