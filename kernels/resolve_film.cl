// Surfel values to pixels by the reconstruction filter, over all visibility samples of all pixels in its support.

#include "shared/film.h"

/// launch : 1-D, one work-item per pixel
/// in     : values, fields first_field .. first_field + 2 of [field][capacity]; slots, counts, first_surfel; weights[(2 reach + 1)^2 *
/// sample_count]: the filter at each sample of each
///          neighbour, row by row; totals[(2 reach + 1)^2]: sums over the samples of a neighbour
///          background[pixel * 3 + channel], if has_background: what samples show that show no surface
/// out    : image[pixel * 3 + channel]
kernel void resolve_film(global const float *values, int first_field, int capacity, global const uchar *slots, global const uchar *counts,
                         global const int *first_surfel, global const float *weights, global const float *totals, int reach,
                         int sample_count, int width, int height, global const float *background, int has_background, global float *image) {
    int pixel = get_global_id(0);
    if (pixel >= width * height) return;
    int2 centre = (int2)(pixel % width, pixel / width);
    float3 sum = (float3)(0.0f);
    float norm = 0.0f;
    for (int dy = -reach; dy <= reach; ++dy)
        for (int dx = -reach; dx <= reach; ++dx) {
            int2 p = centre + (int2)(dx, dy);
            if (p.x < 0 || p.x >= width || p.y < 0 || p.y >= height) continue;
            int cell = (dy + reach) * (2 * reach + 1) + dx + reach;
            int other = p.y * width + p.x;
            norm += totals[cell];
            global const float *v = values + (size_t)first_field * capacity + first_surfel[other];
            global const uchar *slot = slots + (size_t)other * sample_count;
            if (counts[other] == 1) {  // one surface, no empty sample
                sum += totals[cell] * (float3)(v[0], v[capacity], v[2 * (size_t)capacity]);
                continue;
            }
            for (int s = 0; s < sample_count; ++s)
                if (slot[s] != NO_SURFEL)
                    sum += weights[cell * sample_count + s] *
                           (float3)(v[slot[s]], v[(size_t)capacity + slot[s]], v[2 * (size_t)capacity + slot[s]]);
                else if (has_background)
                    sum += weights[cell * sample_count + s] * vload3(other, background);
        }
    vstore3(norm > 0.0f ? sum / norm : (float3)(0.0f), pixel, image);
}
