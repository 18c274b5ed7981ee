// Cube map in six panels, thesis 4.3: panel 2 a + s is the face across axis a (0: x, 1: y, 2: z), s = 1 on the negative side. On it u runs
// along the next axis and v along the one after (x, y, z, x ...).

#include "lib/footprint.cl"
#include "lib/packet.cl"
#include "lib/panels.cl"

/// (along axis a, next, next but one) as (x, y, z).
static inline float4 cube_turn(float major, float u, float v, int axis) {
    if (axis == 0) return (float4)(major, u, v, 0.0f);
    return axis == 1 ? (float4)(v, major, u, 0.0f) : (float4)(u, v, major, 0.0f);
}

static inline float4 cube_to_direction(float u, float v, int panel) { return cube_turn(panel & 1 ? -1.0f : 1.0f, u, v, panel / 2); }

/// Gutter texels repeat the edge texel of the next face; at a corner, where three faces meet, the gutter texels of all three hold the
/// direction of the corner itself. Bilinear look-ups are continuous across edges and corners.
static inline float4 cube_stored_direction(int2 texel, int panel, int n) {
    float u = panel_coordinate(texel.x, n), v = panel_coordinate(texel.y, n), major = 1.0f;
    bool across_u = texel.x < 0 || texel.x >= n, across_v = texel.y < 0 || texel.y >= n;
    if (across_u && !across_v) major = 2.0f - fabs(u);
    if (across_v && !across_u) major = 2.0f - fabs(v);
    if (across_u) u = copysign(1.0f, u);
    if (across_v) v = copysign(1.0f, v);
    return cube_turn(panel & 1 ? -major : major, u, v, panel / 2);
}

/// Beyond an edge lies the face of the axis across it, where the old axis takes the place of the one that was left: texel d outside is texel d
/// from that face's edge. Beyond a corner the way is taken twice, first across u, so that each of the three faces that meet there
/// sees the other two.
static inline int2 cube_fold_texel(int2 texel, int panel, int n) {
    for (int crossing = 0; crossing < 2; ++crossing) {
        bool across_u = texel.x < 0 || texel.x >= n, across_v = texel.y < 0 || texel.y >= n;
        if (!across_u && !across_v) break;
        int at = across_u ? texel.x : texel.y, depth = at < 0 ? -1 - at : at - n;
        int along = panel & 1 ? depth : n - 1 - depth;
        texel = across_u ? (int2)(texel.y, along) : (int2)(along, texel.x);
        panel = (panel / 2 + (across_u ? 1 : 2)) % 3 * 2 + (at < 0 ? 1 : 0);
    }
    return texel_of_panel(texel, panel, n);
}

static inline float cube_solid_angle_density(float u, float v, int panel) {
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
    vint panel = select(select((vint)(4), (vint)(2), is_y), (vint)(0), is_x) + (PACKET_MASK(major < 0.0f) & 1);
    vfloat scale = 1.0f / fmax(fabs(major), (vfloat)(FOOTPRINT_TINY));
    return panel_footprint(u * scale, v * scale, panel, n);
}
