// Writes the surfels of the film: one per surface that a pixel shows, at one of that surface's samples. A single image takes the one nearest to
// their middle, which is the best that one point can say. Of many images each takes another: their mean is the mean over the pixel, while
// middles would only ever show middles, however small a bright spot is.

#include "lib/camera_ray.cl"
#include "lib/hash.cl"
#include "lib/surfel.cl"
#include "shared/camera.h"
#include "shared/film.h"
#include "shared/geometry.h"
#include "shared/material.h"

/// The sample of surfel k nearest to the middle of its samples.
static inline int middle_sample(global const float2 *offsets, global const uchar *slot, int sample_count, int k) {
    float2 middle = (float2)(0.0f);
    int members = 0;
    for (int s = 0; s < sample_count; ++s)
        if (slot[s] == k) {
            middle += offsets[s];
            ++members;
        }
    middle /= (float)members;
    int nearest = 0;
    float least = INFINITY;
    for (int s = 0; s < sample_count; ++s) {
        float2 apart = offsets[s] - middle;
        if (slot[s] == k && dot(apart, apart) < least) {
            least = dot(apart, apart);
            nearest = s;
        }
    }
    return nearest;
}

/// The sample of surfel k at share `u` of its samples, as a fraction of 2^32.
static inline int drawn_sample(global const uchar *slot, int sample_count, int k, uint u) {
    uint members = 0;
    for (int s = 0; s < sample_count; ++s) members += slot[s] == k;
    int s = -1;
    for (uint left = mul_hi(u, members) + 1; left > 0; left -= slot[s] == k) ++s;
    return s;
}

/// launch : 1-D, one work-item per pixel of a strip of rows
/// in     : hits, slots, counts of the strip; first_surfel[pixel] of the whole film; seed: of the samples that surfels take, 0: the middle
///          ones; shift: of the shares at which they lie, as a fraction of 2^32
/// out    : surfels; drawn[surfel]: the sample that it lies at
kernel void film_surfels(global const Hit *hits, Camera camera, global const float2 *offsets, int sample_count, int first_row,
                         int row_count, uint seed, uint shift, global const uchar *slots, global const uchar *counts,
                         global const int *first_surfel, SURFACES_PARAMETERS, global float *surfels, int capacity, global uchar *drawn) {
    int item = get_global_id(0);
    if (item >= row_count * camera.width) return;
    float2 corner = (float2)(item % camera.width, first_row + item / camera.width);
    size_t pixel = (size_t)first_row * camera.width + item;
    size_t image = (size_t)row_count * camera.width;
    global const uchar *slot = slots + pixel * sample_count;
    Surfaces scene = SURFACES;
    for (int k = 0; k < (counts[pixel] & FILM_COUNT_MASK); ++k) {
        uint bits = hash_uint(seed ^ hash_uint((uint)pixel * PENCIL_FILM_SAMPLES + k)) + shift;
        int s = seed == 0 ? middle_sample(offsets, slot, sample_count, k) : drawn_sample(slot, sample_count, k, bits);
        drawn[first_surfel[pixel] + k] = (uchar)s;
        CameraRay ray = camera_ray(&camera, corner + offsets[s], offsets, s, sample_count);
        write_surfel(surfels, capacity, first_surfel[pixel] + k, hits[s * image + item], ray.origin, ray.direction, &scene,
                     hash_uint(bits));
    }
}
