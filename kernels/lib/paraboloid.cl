// Dual paraboloid map, thesis eqs (4.3), (4.4): tile 0 is the hemisphere z >= 0, tile 1 the other; a hemisphere fills the unit circle.
//

#include "lib/footprint.cl"
#include "lib/map_tiles.cl"
#include "lib/packet.cl"

/// Direction through (u, v); outside the circle it is of the other hemisphere, by the same formula.
static inline float4 paraboloid_to_direction(float u, float v, int tile) {
    float z = 0.5f * (1.0f - u * u - v * v);
    return (float4)(u, v, tile ? -z : z, 0.0f);
}

/// Texels outside the circle continue the map: they hold what lies across the seam. Its two sides meet up to interpolation error.
static inline float4 paraboloid_stored_direction(int2 texel, int tile, int n) {
    return paraboloid_to_direction(tile_coordinate(texel.x, n), tile_coordinate(texel.y, n), tile);
}

static inline float paraboloid_solid_angle_density(float u, float v, int tile) {
    float r2 = u * u + v * v, q = 0.5f * (1.0f + r2);  // q: length of the direction, and the factor of its map's area
    return r2 <= 1.0f ? 1.0f / (q * q) : 0.0f;
}

static inline Footprint paraboloid_footprint(vfloat vx, vfloat vy, vfloat vz, int n) {
    vfloat length = sqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
    vfloat scale = 1.0f / fmax(fabs(vz) + length, (vfloat)(FOOTPRINT_TINY));
    return tile_footprint(vx * scale, vy * scale, dual_tile(vz), n);
}
