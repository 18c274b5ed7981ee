// Emitters as light paths that check an image choose them: one at a time, mostly by power (certify/emitter_table.cpp).

#include "lib/colour.cl"
#include "lib/light_profile.cl"
#include "lib/sky.cl"
#include "lib/surfaces.cl"
#include "shared/emitter.h"

/// Emitters that paths choose from.
typedef struct CheckLights {
    global const Emitter *emitters;
    int count;
    global const float *densities;  // by material: of points of triangles [1/scene units^2]
    float sky_density;              // of directions of the sky, for each unit of luminance above its limit
    global const Sky *sky;
    global const float4 *sky_texels;
} CheckLights;

/// The emitter at share u of all chances.
static inline int find_emitter(global const Emitter *emitters, int count, float u) {
    int low = 0, high = count - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (emitters[middle].emission.w > u)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/// Light that an emitter sends to a vertex, if nothing stands between.
typedef struct Aim {
    float3 segment;    // to a point of it; infinitely far: a unit direction
    float3 direction;  // unit
    float3 light;      // radiance, or irradiance across the direction over its chance where density is 0; 0: it sends none
    float density;     // of light samples per solid angle [1/sr], 0: of what rays do not find
    bool far;
} Aim;

/// Density per solid angle of light samples of the sky in a direction of luminance `size` [1/sr].
static inline float sky_density(const CheckLights *lights, float size) {
    return fmax(size - lights->sky->limit, 0.0f) * lights->sky_density;
}

/// A point of a texel of the sky.
static inline void aim_at_sky(const CheckLights *lights, global const Emitter *e, float v, float w, Aim *a) {
    global const Sky *sky = lights->sky;
    float high = cos(sky_edge(sky, e->row)), low = cos(sky_edge(sky, e->row + 1));
    float z = mix(low, high, v), r = sqrt(fmax(1.0f - z * z, 0.0f)), phi = 2.0f * M_PI_F * (e->column + w) / sky->width;
    float3 d = (float3)(r * sin(phi), z, -r * cos(phi));
    a->segment = a->direction = d.x * sky->to_local[0].xyz + d.y * sky->to_local[1].xyz + d.z * sky->to_local[2].xyz;
    float3 all = lights->sky_texels[(size_t)e->row * sky->width + e->column].xyz;
    float size = luminance(all);
    a->light = all * (1.0f - sky->limit / size);
    a->density = sky_density(lights, size);
    a->far = true;
}

/// A point light, a spot, or parallel light.
static inline void aim_at_point(float3 x, global const Emitter *e, global const half *tables, Aim *a) {
    a->density = 0.0f;
    if (e->triangle == EMITTER_PARALLEL) {
        a->segment = a->direction = -e->axis.xyz;
        a->light = e->emission.xyz / e->chance;
        a->far = true;
        return;
    }
    a->segment = e->position.xyz - x;
    float square = dot(a->segment, a->segment), share = 1.0f;
    a->direction = a->segment * rsqrt(square);
    if (PENCIL_FAR_LIGHT && e->position.w > 0.0f) {
        float angle = acos(clamp(-dot(e->axis.xyz, a->direction), -1.0f, 1.0f));
        share = clamp((e->position.w - angle) / fmax(e->position.w - e->axis.w, 1e-6f), 0.0f, 1.0f);
    }
    if (PENCIL_FAR_LIGHT && e->position.w < 0.0f) share = profile_share(tables, (int)(-1.0f - e->position.w), e->axis.xyz, -a->direction);
    a->light = e->emission.xyz * (share / (square * e->chance));
}

/// An emitter, chosen by chance, and a point of it, as x receives it; random: in [0, 1)^3.
static inline Aim aim_check(float3 x, float3 random, const CheckLights *lights, const Surfaces *scene) {
    float u = random.x, v = random.y, w = random.z;
    Aim a = {(float3)(0.0f), (float3)(0.0f), (float3)(0.0f), 0.0f, false};
    global const Emitter *e = lights->emitters + find_emitter(lights->emitters, lights->count, u);
    if (PENCIL_SKY && e->triangle == EMITTER_SKY) {
        aim_at_sky(lights, e, v, w, &a);
    } else if (e->triangle < 0) {
        aim_at_point(x, e, scene->bitmaps, &a);
    } else {
        global const Triangle *t = scene->triangles + e->triangle;
        float root = sqrt(v);
        float3 corners = (float3)(1.0f - root, root * (1.0f - w), root * w);
        a.segment = (corners.x * t->v0 + corners.y * t->v1 + corners.z * t->v2).xyz - x;
        float square = dot(a.segment, a.segment);
        a.direction = a.segment * rsqrt(square);
        float light_cosine = -dot(scene->planes[t->plane].xyz, a.direction);
        if (!(light_cosine > 0.0f)) return a;
        TexturePoint at = texture_point(scene, e->triangle, corners);
        a.light = emission_at(scene, scene->materials + t->material, &at);
        a.density = lights->densities[t->material] * square / light_cosine;
    }
    return a;
}
