// The family of dual maps of thesis 4.3.1: u = vx / (|vz| + d), v = vy / (|vz| + d) with
//   d = |(vx, vy, vz)|_p, eq. (4.5)          a superquadric paraboloid (PENCIL_SUPERQUADRIC_CONE 0); p = 2 is the paraboloid map
//   d = |(vx, vy)|_p, eqs (4.9) to (4.11)    a superquadric cone (PENCIL_SUPERQUADRIC_CONE 1); p = INFINITY is the pyramid map, and p = 1
//                                            is one half of the octahedral map
// Panel 0 is the hemisphere z >= 0, panel 1 the other; a hemisphere fills |(u, v)|_p <= 1.

#include "lib/footprint.cl"
#include "lib/packet.cl"
#include "lib/panels.cl"

#if !defined(PENCIL_SUPERQUADRIC_EXPONENT) || !defined(PENCIL_SUPERQUADRIC_CONE)
#error PENCIL_SUPERQUADRIC_EXPONENT (1 to INFINITY) and PENCIL_SUPERQUADRIC_CONE (0 or 1) choose the map
#endif
#define SUPERQUADRIC_P ((float)PENCIL_SUPERQUADRIC_EXPONENT)

/// Halvings of an interval of length 1/2: to the last bit of a float.
#define SUPERQUADRIC_HALVINGS 24

/// L_p norm of (a, b), both >= 0.
static inline float superquadric_norm(float a, float b) {
    if (SUPERQUADRIC_P == 1.0f) return a + b;
    if (SUPERQUADRIC_P == 2.0f) return sqrt(a * a + b * b);
    float most = fmax(a, b);
    if (isinf(SUPERQUADRIC_P) || most == 0.0f) return most;
    return most * powr(powr(a / most, SUPERQUADRIC_P) + powr(b / most, SUPERQUADRIC_P), 1.0f / SUPERQUADRIC_P);
}
static inline vfloat packet_superquadric_norm(vfloat a, vfloat b) {
    if (SUPERQUADRIC_P == 1.0f) return a + b;
    if (SUPERQUADRIC_P == 2.0f) return sqrt(fma(a, a, b * b));
    vfloat most = fmax(fmax(a, b), (vfloat)(FOOTPRINT_TINY));
    if (isinf(SUPERQUADRIC_P)) return most;
    vfloat p = (vfloat)(SUPERQUADRIC_P);
    return most * powr(powr(a / most, p) + powr(b / most, p), 1.0f / p);
}

/// z of the direction (x, y, z) with z + d = 1 whose (x, y) has norm r <= 1.
static inline float superquadric_height_inside(float r) {
    if (PENCIL_SUPERQUADRIC_CONE) return 1.0f - r;
    if (SUPERQUADRIC_P == 1.0f) return 0.5f * (1.0f - r);
    if (SUPERQUADRIC_P == 2.0f) return 0.5f * (1.0f - r * r);
    if (isinf(SUPERQUADRIC_P)) return fmin(0.5f, 1.0f - r);
    float low = 0.0f, high = 0.5f, target = powr(r, SUPERQUADRIC_P);  // (1 - z)^p - z^p = r^p; the left side falls from 1 to 0
    for (int i = 0; i < SUPERQUADRIC_HALVINGS; ++i) {
        float z = 0.5f * (low + high);
        if (powr(1.0f - z, SUPERQUADRIC_P) - powr(z, SUPERQUADRIC_P) > target)
            low = z;
        else
            high = z;
    }
    return 0.5f * (low + high);
}

/// Direction through (u, v). Beyond |(u, v)|_p = 1 the base is continued by its point reflection about the rim: into the other hemisphere.
static inline float4 superquadric_to_direction(float u, float v, int panel) {
    float r = superquadric_norm(fabs(u), fabs(v));
    float z = r <= 1.0f ? superquadric_height_inside(r) : -superquadric_height_inside(fmax(2.0f - r, 0.0f));
    return (float4)(u, v, panel ? -z : z, 0.0f);
}

/// Texels beyond the rim continue the map: they hold what lies across the seam. Its two sides meet up to interpolation error.
static inline float4 superquadric_stored_direction(int2 texel, int panel, int n) {
    return superquadric_to_direction(panel_coordinate(texel.x, n), panel_coordinate(texel.y, n), panel);
}

/// g / |d|^3 with d the direction of superquadric_to_direction; g = z - r dz/dr is 1 for cones (Euler's theorem).
static inline float superquadric_solid_angle_density(float u, float v, int panel) {
    float r = superquadric_norm(fabs(u), fabs(v));
    if (r > 1.0f) return 0.0f;
    float z = superquadric_height_inside(r), g = 1.0f, length2 = u * u + v * v + z * z;
    if (!PENCIL_SUPERQUADRIC_CONE) {
        if (SUPERQUADRIC_P == 1.0f) return 0.5f / (length2 * sqrt(length2));
        if (isinf(SUPERQUADRIC_P)) return (r < 0.5f ? 0.5f : 1.0f) / (length2 * sqrt(length2));
        float outer = powr(1.0f - z, SUPERQUADRIC_P - 1.0f);
        g = outer / (outer + powr(z, SUPERQUADRIC_P - 1.0f));
    }
    return g / (length2 * sqrt(length2));
}

static inline Footprint superquadric_footprint(vfloat vx, vfloat vy, vfloat vz, int n) {
    vfloat d = packet_superquadric_norm(fabs(vx), fabs(vy));
    if (!PENCIL_SUPERQUADRIC_CONE) d = packet_superquadric_norm(d, fabs(vz));
    vfloat scale = 1.0f / fmax(fabs(vz) + d, (vfloat)(FOOTPRINT_TINY));
    return panel_footprint(vx * scale, vy * scale, dual_panel(vz), n);
}
