// Dual pyramid map, thesis eq. (4.12): panel 0 is the hemisphere z >= 0, panel 1 the other; a hemisphere fills the square. Linear in each
// of the four faces |v| <= |u|, |u| <= |v|.

#include "lib/footprint.cl"
#include "lib/packet.cl"
#include "lib/panels.cl"

/// Direction through (u, v), inverse of eq. (4.12).
static inline float4 pyramid_to_direction(float u, float v, int panel) {
    float z = 1.0f - fmax(fabs(u), fabs(v));
    return (float4)(u, v, panel ? -z : z, 0.0f);
}

/// Beyond an edge lies the edge of the other panel at the same place: texel d outside is texel d from it. A corner crosses twice, and is that
/// of the same panel.
static inline int2 pyramid_fold_texel(int2 texel, int panel, int n) {
    int2 mirrored = select(select(texel, 2 * n - 1 - texel, texel >= n), -1 - texel, texel < 0);
    int crossings = (texel.x != mirrored.x ? 1 : 0) + (texel.y != mirrored.y ? 1 : 0);
    return texel_of_panel(mirrored, (panel + crossings) & 1, n);
}

/// Gutter texels repeat the texel across the seam. Bilinear look-ups are continuous across seams and corners.
static inline float4 pyramid_stored_direction(int2 texel, int panel, int n) {
    int2 shown = pyramid_fold_texel(texel, panel, n), inside = texel_in_panel(shown, n);
    return pyramid_to_direction(panel_coordinate(inside.x, n), panel_coordinate(inside.y, n), panel_of_texel(shown, n));
}

static inline float pyramid_solid_angle_density(float u, float v, int panel) {
    float4 d = pyramid_to_direction(u, v, panel);
    float r = length(d.xyz);
    return 1.0f / (r * r * r);
}

static inline Footprint pyramid_footprint(vfloat vx, vfloat vy, vfloat vz, int n) {
    vfloat scale = 1.0f / fmax(fabs(vz) + fmax(fabs(vx), fabs(vy)), (vfloat)(FOOTPRINT_TINY));
    return panel_footprint(vx * scale, vy * scale, dual_panel(vz), n);
}
