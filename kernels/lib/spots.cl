// Bright spots as a surface pencil sees them: spheres about places that reflect much of the light. Directions into their cones are drawn beside
// those of the texels, and both are weighed by the balance heuristic (Veach 1997, 9.2).

#include "lib/hemisphere.cl"
#include "shared/spot.h"
#include "shared/surface_pencil.h"

/// Cones are at least this wide, the sine of their half angle: narrower ones are not told from their axis by float.
#define SPOT_LEAST_SINE 0.001f
/// Pencils nearer to a spot than so many of its radii see it well enough by their texels.
#define SPOT_NEAREST 1.5f

/// Share of a cone at its edge that is left out, so that rounding takes no direction out of it.
#define SPOT_MARGIN 5e-4f

/// The spots above the horizon of a pencil.
typedef struct SpotView {
    int count;
    float3 axis[SPOTS_MOST];    // unit
    float opening[SPOTS_MOST];  // 1 - cosine of the cone's half angle
    float chance[SPOTS_MOST];   // of a guided ray, 1 in all
} SpotView;

/// A spot from a place with normal n: its cone, and its chance in units that all spots share. False if it is not seen, or from too near.
typedef struct SpotCone {
    float3 axis;
    float opening, chance;
} SpotCone;

static inline bool spot_cone(float3 x, float3 n, float4 spot, float weight, SpotCone *cone) {
    float3 step = spot.xyz - x;
    float square = dot(step, step), radius = spot.w;
    if (!(square > SPOT_NEAREST * SPOT_NEAREST * radius * radius)) return false;
    float inverse = rsqrt(square), sine = fmax(radius * inverse, SPOT_LEAST_SINE);
    float height = fmin(dot(step, n) * inverse + sine, 1.0f);
    if (!(height > 0.0f)) return false;
    cone->axis = step * inverse;
    cone->opening = sine * sine / (1.0f + sqrt(1.0f - sine * sine));
    cone->chance = weight * height / square;
    return true;
}

/// The cone holds the direction: |direction - axis|^2 = 2 (1 - cosine), without the cancellation.
static inline bool cone_holds(float3 axis, float opening, float3 direction) {
    float3 aside = direction - axis;
    return dot(aside, aside) <= 2.0f * opening;
}

static inline SpotView view_spots(global const SurfacePencil *pencil, global const float4 *spots, global const float *weights,
                                  int spot_count) {
    SpotView v;
    v.count = 0;
    float total = 0.0f;
    for (int k = 0; k < spot_count; ++k) {
        SpotCone cone;
        if (!spot_cone(pencil->position.xyz, pencil->normal.xyz, spots[k], weights[k], &cone)) continue;
        v.axis[v.count] = cone.axis;
        v.opening[v.count] = cone.opening;
        v.chance[v.count++] = cone.chance;
        total += cone.chance;
    }
    for (int k = 0; k < v.count; ++k) v.chance[k] /= total;
    if (!(total > 0.0f)) v.count = 0;
    return v;
}

/// With which guided rays are drawn in a direction [1/sr].
static inline float spots_density(const SpotView *v, float3 direction) {
    float density = 0.0f;
    for (int k = 0; k < v->count; ++k)
        if (cone_holds(v->axis[k], v->opening[k], direction)) density += v->chance[k] / (2.0f * M_PI_F * v->opening[k]);
    return density;
}

/// A direction into a cone; rise, turn: uniform.
static inline float3 direction_into(float3 axis, float opening, float rise, float turn) {
    float down = opening * (1.0f - SPOT_MARGIN) * rise, aside = sqrt(fmax(down * (2.0f - down), 0.0f)), phi = 2.0f * M_PI_F * turn;
    float3 t, b;
    tangent_frame(axis, &t, &b);
    return normalize(aside * cos(phi) * t + aside * sin(phi) * b + (1.0f - down) * axis);
}

/// Number of rays per solid angle [1/sr] at this cosine: of so many texels, and of the guided rays.
static inline float texels_density(int texels, float cosine) { return texels * M_1_PI_F * fmax(cosine, 0.0f); }
static inline float guides_density(const SpotView *v, float3 direction) { return SPOT_RAYS * spots_density(v, direction); }
