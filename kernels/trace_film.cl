// What the camera sees, as rasterize_film.cl makes it, by packets of rays through the hierarchy: where triangles are far more than pixels.

#include "lib/bvh.cl"
#include "lib/camera_ray.cl"
#include "lib/packet.cl"
#include "lib/rays.cl"
#include "shared/bvh.h"
#include "shared/camera.h"
#include "shared/geometry.h"

/// The same where rays have origins of their own. They start at the near distance.
static inline void trace_wide(HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes, const Camera *camera,
                              global const float2 *offsets, int sample_count, int first_row, int first, int count, global Hit *hits) {
    float o[3][PENCIL_WIDTH], d[3][PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int item = min(first + l, count - 1), pixel = item / sample_count, sample = item % sample_count;
        float2 at = (float2)(pixel % camera->width, first_row + pixel / camera->width) + offsets[sample];
        store_camera_ray(camera, camera_ray(camera, at, offsets, sample, sample_count), l, o, d);
    }
    LaneRays rays = lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), PACKET_LOAD(d[0]), PACKET_LOAD(d[1]),
                              PACKET_LOAD(d[2]), (vint)(-1), (vfloat)(camera->far_clip - camera->near_clip));
    lanes_trace(&rays, false, nodes, leaves, triangles, planes);
    for (int l = 0; l < PENCIL_WIDTH && first + l < count; ++l) {
        int item = first + l, triangle = LANE_INT(rays.triangle, l);
        global Hit *hit = hits + (size_t)(item % sample_count) * (count / sample_count) + item / sample_count;
        hit->triangle = triangle;
        hit->disparity = triangle < 0 ? 0.0f : 1.0f / (LANE_FLOAT(rays.nearest, l) + camera->near_clip);
    }
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH samples of a strip of rows, those of a pixel one after the other
/// in     : the scene and its hierarchy; camera; offsets[sample] in [0, 1)^2, the same for every pixel
/// out    : as rasterize_film
/// clip   : as rasterize_film
kernel void trace_film(HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes, Camera camera,
                       global const float2 *offsets, int sample_count, int first_row, int row_count, global Hit *hits) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    int pixels = row_count * camera.width, count = pixels * sample_count;
    if (first >= count) return;
#if PENCIL_WIDE_CAMERA
    trace_wide(nodes, leaves, triangles, planes, &camera, offsets, sample_count, first_row, first, count, hits);
    return;
#endif
    float x[PENCIL_WIDTH], y[PENCIL_WIDTH], z[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int item = min(first + l, count - 1), pixel = item / sample_count;
        float2 at = (float2)(pixel % camera.width, first_row + pixel / camera.width) + offsets[item % sample_count];
        float4 direction = camera.corner + at.x * camera.step_x + at.y * camera.step_y;
        x[l] = direction.x;
        y[l] = direction.y;
        z[l] = direction.z;
    }
    RayPacket rays = ray_packet(PACKET_LOAD(x), PACKET_LOAD(y), PACKET_LOAD(z));
    rays.most = camera.near_clip > 0.0f ? 1.0f / camera.near_clip : INFINITY;
    packet_trace(&rays, (float4)(camera.origin.xyz, 0.0f), -1, -1.0f, nodes, leaves, triangles, planes);
    float farthest = 1.0f / camera.far_clip;
    for (int l = 0; l < PENCIL_WIDTH && first + l < count; ++l) {
        int item = first + l;
        global Hit *hit = hits + (size_t)(item % sample_count) * pixels + item / sample_count;
        float disparity = LANE_FLOAT(rays.disparity, l);
        hit->triangle = disparity < farthest ? -1 : LANE_INT(rays.triangle, l);
        hit->disparity = disparity;
    }
}
