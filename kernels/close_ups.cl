// Close-ups: what lies about the visibility samples of pixels that need a finer look, several surfels for each sample.

#include "lib/bvh.cl"
#include "lib/camera_ray.cl"
#include "lib/hash.cl"
#include "lib/packet.cl"
#include "lib/rays.cl"
#include "lib/surfel.cl"
#include "shared/bvh.h"
#include "shared/camera.h"
#include "shared/geometry.h"
#include "shared/material.h"

/// Surfel `item` of all: one of `each` about a sample of a pixel. Steps turn back at the edges of the pixel: no part of it is seen more often,
/// and none by a sample whose filter weights are those of another edge.
static inline CameraRay close_ray(int item, global const int *pixels, const Camera *camera, global const float2 *offsets, int sample_count,
                                  global const float2 *steps, int each) {
    int s = item / each % sample_count, pixel = pixels[item / (each * sample_count)];
    float2 at = offsets[s] + steps[item % each];
    at = 1.0f - fabs(1.0f - fabs(at));
    return camera_ray(camera, at + (float2)(pixel % camera->width, pixel / camera->width), offsets, s, sample_count);
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels
/// in     : pixels[pixel_count]; offsets as in trace_film; steps[each] from a sample, at most half a pixel; seed: of what blends show; the scene
///          and its hierarchy
/// out    : surfels: `each` for every sample of every pixel, in this order
kernel void close_ups(global const int *pixels, int pixel_count, Camera camera, global const float2 *offsets, int sample_count,
                      global const float2 *steps, int each, uint seed, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *surfels,
                      int capacity) {
    int first = get_global_id(0) * PENCIL_WIDTH, count = pixel_count * sample_count * each;
    if (first >= count) return;
    float o[3][PENCIL_WIDTH], d[3][PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l)
        store_camera_ray(&camera, close_ray(min(first + l, count - 1), pixels, &camera, offsets, sample_count, steps, each), l, o, d);
    LaneRays rays = lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), PACKET_LOAD(d[0]), PACKET_LOAD(d[1]),
                              PACKET_LOAD(d[2]), (vint)(-1), (vfloat)(camera.far_clip - camera.near_clip));
    lanes_trace(&rays, false, nodes, leaves, triangles, planes);
    Surfaces scene = SURFACES;
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH && first + l < count; ++l) {
        CameraRay ray = close_ray(first + l, pixels, &camera, offsets, sample_count, steps, each);
        Hit hit = {LANE_INT(rays.triangle, l), 1.0f / (LANE_FLOAT(rays.nearest, l) + camera.near_clip)};
        write_surfel(surfels, capacity, first + l, hit, ray.origin, ray.direction, &scene, hash_uint(seed ^ hash_uint(first + l)));
    }
}
