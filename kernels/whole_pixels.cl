// Light of the pixels that show one thing alone, side by side for resolve_film, which looks at each of them many times.

#include "shared/film.h"

/// launch : 1-D, one work-item per pixel
/// in     : values, fields first_field .. first_field + 2 of [field][capacity]; counts, first_surfel of the pixels; background[pixel * 3 +
///          channel], if has_background: what samples show that show no surface
/// out    : whole[pixel]: rgb of its surfel, or of no surface at all, and 1; 0 where it shows more
kernel void whole_pixels(global const float *values, int first_field, int capacity, global const uchar *counts,
                         global const int *first_surfel, int pixels, global const float *background, int has_background,
                         global float4 *whole) {
    int pixel = get_global_id(0);
    if (pixel >= pixels) return;
    float4 light = (float4)(0.0f);
    if (counts[pixel] == 1) {
        global const float *v = values + (size_t)first_field * capacity + first_surfel[pixel];
        light = (float4)(v[0], v[capacity], v[2 * (size_t)capacity], 1.0f);
    } else if (counts[pixel] == FILM_HAS_EMPTY) {
        light = (float4)(has_background ? vload3(pixel, background) : (float3)(0.0f), 1.0f);
    }
    whole[pixel] = light;
}
