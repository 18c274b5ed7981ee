// Bright spots as a surface pencil sees them: spheres about places that reflect much of the light or that it comes through. Directions into their cones are drawn beside
// those of the texels, and both are weighed by the balance heuristic (Veach 1997, 9.2).

#include "lib/packet.cl"
#include "shared/spot.h"
#include "shared/surface_pencil.h"

/// Cones are at least this wide, the sine of their half angle: narrower ones are not told from their axis by float.
#define SPOT_LEAST_SINE 0.001f
/// Pencils nearer to a spot than so many of its radii see it well enough by their texels.
#define SPOT_NEAREST 1.5f

/// The spots above the horizon of a pencil.
typedef struct SpotView {
    int count;
    float3 axis[SPOTS_MOST];    // unit
    float opening[SPOTS_MOST];  // 1 - cosine of the cone's half angle
    float chance[SPOTS_MOST];   // of a guided ray, 1 in all
} SpotView;

static inline SpotView view_spots(global const SurfacePencil *pencil, global const float4 *spots, global const float *weights,
                                  int spot_count) {
    SpotView v;
    v.count = 0;
    float total = 0.0f;
    for (int k = 0; k < spot_count; ++k) {
        float3 step = spots[k].xyz - pencil->position.xyz;
        float square = dot(step, step), radius = spots[k].w;
        if (!(square > SPOT_NEAREST * SPOT_NEAREST * radius * radius)) continue;
        float inverse = rsqrt(square), sine = fmax(radius * inverse, SPOT_LEAST_SINE);
        float height = fmin(dot(step, pencil->normal.xyz) * inverse + sine, 1.0f);
        if (!(height > 0.0f)) continue;
        v.axis[v.count] = step * inverse;
        v.opening[v.count] = sine * sine / (1.0f + sqrt(1.0f - sine * sine));
        v.chance[v.count] = weights[k] * height / square;
        total += v.chance[v.count++];
    }
    for (int k = 0; k < v.count; ++k) v.chance[k] /= total;
    if (!(total > 0.0f)) v.count = 0;
    return v;
}

/// With which guided rays are drawn in the unit directions of a packet [1/sr].
static inline vfloat spots_density(const SpotView *v, vfloat x, vfloat y, vfloat z) {
    vfloat density = (vfloat)(0.0f);
    for (int k = 0; k < v->count; ++k) {
        vfloat dx = x - v->axis[k].x, dy = y - v->axis[k].y, dz = z - v->axis[k].z;
        // |direction - axis|^2 = 2 (1 - cosine), without the cancellation.
        vint inside = PACKET_MASK(fma(dx, dx, fma(dy, dy, dz * dz)) <= 2.0f * v->opening[k]);
        density += select((vfloat)(0.0f), (vfloat)(v->chance[k] / (2.0f * M_PI_F * v->opening[k])), inside);
    }
    return density;
}

/// Number of rays per solid angle [1/sr] at these cosines: of so many texels, and of the guided rays.
static inline vfloat texels_density(int texels, vfloat cosine) { return texels * M_1_PI_F * fmax(cosine, (vfloat)(0.0f)); }
static inline vfloat guides_density(const SpotView *v, vfloat x, vfloat y, vfloat z) { return SPOT_RAYS * spots_density(v, x, y, z); }
