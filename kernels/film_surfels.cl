// Writes the surfels of the film: one per surface that a pixel shows, at the sample nearest to the middle of that surface's samples.

#include "lib/surfel.cl"
#include "shared/camera.h"
#include "shared/film.h"
#include "shared/geometry.h"
#include "shared/material.h"

/// launch : 1-D, one work-item per pixel of a strip of rows
/// in     : hits, slots, counts of the strip; first_surfel[pixel] of the whole film
/// out    : surfels
kernel void film_surfels(global const Hit *hits, Camera camera, global const float2 *offsets, int sample_count, int first_row,
                         int row_count, global const uchar *slots, global const uchar *counts, global const int *first_surfel,
                         global const Triangle *triangles, global const float4 *planes, global const Material *materials,
                         global const float4 *normals, global float *surfels, int capacity) {
    int item = get_global_id(0);
    if (item >= row_count * camera.width) return;
    float2 corner = (float2)(item % camera.width, first_row + item / camera.width);
    size_t pixel = (size_t)first_row * camera.width + item;
    size_t image = (size_t)row_count * camera.width;
    global const uchar *slot = slots + pixel * sample_count;
    for (int k = 0; k < (counts[pixel] & FILM_COUNT_MASK); ++k) {
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
        float2 p = corner + offsets[nearest];
        float4 d = camera.corner + p.x * camera.step_x + p.y * camera.step_y;
        write_surfel(surfels, capacity, first_surfel[pixel] + k, hits[nearest * image + item], (float4)(camera.origin.xyz, 0.0f),
                     (float4)(d.xyz, 0.0f), triangles, planes, materials, normals);
    }
}
