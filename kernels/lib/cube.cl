// Cube map in six tiles, thesis 4.3: tile 2 a + s is the face across axis a (0: x, 1: y, 2: z), s = 1 on the negative side. On it u runs
// along the next axis and v along the one after (x, y, z, x ...).

#include "lib/footprint.cl"
#include "lib/map_tiles.cl"
#include "lib/packet.cl"

/// (along axis a, next, next but one) as (x, y, z).
static inline float4 cube_turn(float major, float u, float v, int axis) {
    if (axis == 0) return (float4)(major, u, v, 0.0f);
    return axis == 1 ? (float4)(v, major, u, 0.0f) : (float4)(u, v, major, 0.0f);
}

static inline float4 cube_to_direction(float u, float v, int tile) { return cube_turn(tile & 1 ? -1.0f : 1.0f, u, v, tile / 2); }

/// Gutter texels repeat the edge texel of the next face; at a corner, where three faces meet, the gutter texels of all three hold the
/// direction of the corner itself. Bilinear look-ups are continuous across edges and corners.
static inline float4 cube_stored_direction(int2 texel, int tile, int n) {
    float u = tile_coordinate(texel.x, n), v = tile_coordinate(texel.y, n), major = 1.0f;
    bool across_u = texel.x < 0 || texel.x >= n, across_v = texel.y < 0 || texel.y >= n;
    if (across_u && !across_v) major = 2.0f - fabs(u);
    if (across_v && !across_u) major = 2.0f - fabs(v);
    if (across_u) u = copysign(1.0f, u);
    if (across_v) v = copysign(1.0f, v);
    return cube_turn(tile & 1 ? -major : major, u, v, tile / 2);
}

static inline float cube_solid_angle_density(float u, float v, int tile) {
    float r = sqrt(1.0f + u * u + v * v);
    return 1.0f / (r * r * r);
}

static inline Footprint cube_footprint(vfloat vx, vfloat vy, vfloat vz, int n) {
    vfloat ax = fabs(vx), ay = fabs(vy), az = fabs(vz);
    vint is_x = PACKET_MASK(ax >= ay) & PACKET_MASK(ax >= az);
    vint is_y = ~is_x & PACKET_MASK(ay >= az);
    vfloat major = select(select(vz, vy, is_y), vx, is_x);
    vfloat u = select(select(vx, vz, is_y), vy, is_x);
    vfloat v = select(select(vy, vx, is_y), vz, is_x);
    vint tile = select(select((vint)(4), (vint)(2), is_y), (vint)(0), is_x) + (PACKET_MASK(major < 0.0f) & 1);
    vfloat scale = 1.0f / fmax(fabs(major), (vfloat)(FOOTPRINT_TINY));
    return tile_footprint(u * scale, v * scale, tile, n);
}
