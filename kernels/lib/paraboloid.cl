// Dual paraboloid map, thesis eqs (4.3), (4.4): panel 0 is the hemisphere z >= 0, panel 1 the other; a hemisphere fills the unit circle.

#include "lib/footprint.cl"
#include "lib/packet.cl"
#include "lib/panels.cl"

/// Direction through (u, v); outside the circle it is of the other hemisphere, by the same formula.
static inline float4 paraboloid_to_direction(float u, float v, int panel) {
    float z = 0.5f * (1.0f - u * u - v * v);
    return (float4)(u, v, panel ? -z : z, 0.0f);
}

/// Texels outside the circle continue the map: they hold what lies across the seam. Its two sides meet up to interpolation error.
static inline float4 paraboloid_stored_direction(int2 texel, int panel, int n) {
    return paraboloid_to_direction(panel_coordinate(texel.x, n), panel_coordinate(texel.y, n), panel);
}

/// Texels outside the circle see for themselves, those outside the square show the nearest texel of the other panel: there the direction
/// through (u, v) has the coordinates (u, v) / (u^2 + v^2).
static inline int2 paraboloid_fold_texel(int2 texel, int panel, int n) {
    if (min(texel.x, texel.y) >= 0 && max(texel.x, texel.y) < n) return texel_of_panel(texel, panel, n);
    float u = panel_coordinate(texel.x, n), v = panel_coordinate(texel.y, n), inverse = 1.0f / (u * u + v * v);
    int x = (int)((u * inverse + 1.0f) * (0.5f * n)), y = (int)((v * inverse + 1.0f) * (0.5f * n));
    return texel_of_panel(clamp((int2)(x, y), (int2)(0), (int2)(n - 1)), 1 - panel, n);
}

static inline float paraboloid_solid_angle_density(float u, float v, int panel) {
    float r2 = u * u + v * v, q = 0.5f * (1.0f + r2);  // q: length of the direction, and the factor of its map's area
    return r2 <= 1.0f ? 1.0f / (q * q) : 0.0f;
}

static inline Footprint paraboloid_footprint(vfloat vx, vfloat vy, vfloat vz, int n) {
    vfloat length = sqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
    vfloat scale = 1.0f / fmax(fabs(vz) + length, (vfloat)(FOOTPRINT_TINY));
    return panel_footprint(vx * scale, vy * scale, dual_panel(vz), n);
}
