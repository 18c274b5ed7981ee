// Groups the visibility samples of each pixel into surfels: a pixel is shaded once per surface that it shows, and antialiased over all
// of its samples. Interior pixels have one surfel, edges a few.

#include "lib/camera_ray.cl"
#include "shared/camera.h"
#include "shared/film.h"
#include "shared/geometry.h"

/// Samples of one shape and material join if they show one plane, or if their facets are nearly parallel and the points lie near each
/// other's plane.
#define JOIN_COSINE 0.98f
#define JOIN_SLOPE 0.25f

static inline bool joins(Hit a, Hit b, CameraRay ra, CameraRay rb, global const Triangle *triangles, global const float4 *planes) {
    global const Triangle *ta = triangles + a.triangle;
    global const Triangle *tb = triangles + b.triangle;
    if (ta->plane == tb->plane) return true;
    if (ta->shape != tb->shape || ta->material != tb->material) return false;
    float3 na = planes[ta->plane].xyz;
    if (dot(na, planes[tb->plane].xyz) < JOIN_COSINE) return false;
    float3 offset = (ra.direction / a.disparity - rb.direction / b.disparity + (ra.origin - rb.origin)).xyz;
    return fabs(dot(na, offset)) <= JOIN_SLOPE * length(offset);
}

/// launch : 1-D, one work-item per pixel of a strip of rows
/// in     : hits of rasterize_film; offsets; split[pixel], if has_split: not 0 where every sample is to have a surfel of its own
/// out    : slots[pixel * sample_count + sample]: surfel of the sample, counted within the pixel, 255 if it shows nothing;
///          counts[pixel]: surfels of the pixel, plus FILM_HAS_EMPTY if a sample shows nothing. Pixels are counted from the film's first.
kernel void classify_film(global const Hit *hits, Camera camera, global const float2 *offsets, int sample_count, int first_row,
                          int row_count, global const Triangle *triangles, global const float4 *planes, global const uchar *split,
                          int has_split, global uchar *slots, global uchar *counts) {
    int item = get_global_id(0);
    if (item >= row_count * camera.width) return;
    float2 corner = (float2)(item % camera.width, first_row + item / camera.width);
    size_t pixel = (size_t)first_row * camera.width + item;
    size_t image = (size_t)row_count * camera.width;
    uchar leader[PENCIL_FILM_SAMPLES];
    int count = 0, empty = 0, joined = !has_split || !split[pixel];
    for (int s = 0; s < sample_count; ++s) {
        Hit hit = hits[s * image + item];
        int slot = NO_SURFEL;
        if (hit.triangle < 0) {
            empty = FILM_HAS_EMPTY;
        } else {
            CameraRay d = camera_ray(&camera, corner + offsets[s], offsets, s, sample_count);
            for (slot = joined ? 0 : count; slot < count; ++slot) {
                CameraRay e = camera_ray(&camera, corner + offsets[leader[slot]], offsets, leader[slot], sample_count);
                if (joins(hits[leader[slot] * image + item], hit, e, d, triangles, planes)) break;
            }
            if (slot == count) leader[count++] = (uchar)s;
        }
        slots[pixel * sample_count + s] = (uchar)slot;
    }
    counts[pixel] = (uchar)(count | empty);
}
