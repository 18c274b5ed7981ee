// Radiance of the environment by direction.

#include "lib/colour.cl"
#include "shared/sky.h"

/// Parameters of kernels: the environment, and its texels row by row.
#define SKY_PARAMETERS global const Sky *sky, global const float4 *sky_texels
#define SKY_ARGUMENTS sky, sky_texels

/// Place on the map of a unit direction, in texels: the first and last rows are centred on the poles (Mitsuba).
static inline float2 sky_place(global const Sky *e, float3 d) {
    float3 v = (float3)(dot(e->to_local[0].xyz, d), dot(e->to_local[1].xyz, d), dot(e->to_local[2].xyz, d));
    float u = atan2(v.x, -v.z) * (0.5f * M_1_PI_F);
    return (float2)((u - floor(u)) * e->width, acos(clamp(v.y, -1.0f, 1.0f)) * M_1_PI_F * (e->height - 1) + 0.5f);
}

/// Angle to the pole at the upper edge of a row.
static inline float sky_edge(global const Sky *e, int row) {
    return e->height > 1 ? clamp((row - 0.5f) / (e->height - 1), 0.0f, 1.0f) * M_PI_F : row * M_PI_F;
}

static inline float3 sky_texel(SKY_PARAMETERS, float3 d) {
    float2 at = sky_place(sky, d);
    int x = clamp((int)at.x, 0, sky->width - 1), y = clamp((int)at.y, 0, sky->height - 1);
    return sky_texels[(size_t)y * sky->width + x].xyz;
}

/// Between the texels, as a camera sees it.
static inline float3 sky_seen(SKY_PARAMETERS, float3 d) {
    float2 at = sky_place(sky, d) - 0.5f, low = floor(at), f = at - low;
    int w = sky->width, h = sky->height, x = (int)low.x, y = (int)low.y;
    int left = (x + w) % w, right = (x + 1) % w, top = clamp(y, 0, h - 1), bottom = clamp(y + 1, 0, h - 1);
    float4 upper = mix(sky_texels[(size_t)top * w + left], sky_texels[(size_t)top * w + right], f.x);
    float4 lower = mix(sky_texels[(size_t)bottom * w + left], sky_texels[(size_t)bottom * w + right], f.x);
    return mix(upper, lower, f.y).xyz;
}

/// Radiance for a ray that was scattered into direction d with this density [1/sr] over the number of light samples of the sky, 0: without width, below 0: light samples have taken all that
/// they can take. The parts above the limit are shared with light samples by the balance heuristic (Veach 1997, 9.2).
static inline float3 sky_radiance(SKY_PARAMETERS, float3 d, float density) {
    float3 all = sky_texel(sky, sky_texels, d);
    float size = luminance(all);
    if (size <= sky->limit || density == 0.0f) return all;
    float3 low = all * (sky->limit / size);
    if (density < 0.0f) return low;
    float samples = sky->each_sample * (size - sky->limit);
    return low + (all - low) * (density / (density + samples));
}
