// What the camera sees, by the core of the octahedral rasteriser: the film is one more linear projection.

#include "lib/raster.cl"
#include "lib/triangle.cl"
#include "shared/camera.h"
#include "shared/geometry.h"

/// Slack of the bounding box [pixels].
#define FILM_SLACK 1e-2f

/// Renders the scene at `sample_count` positions inside every pixel of a strip of rows.
/// launch : 1-D, one work-item per (sample, band of `band` rows)
/// in     : triangles, planes; camera; bounds[triangle] (bound_film); offsets[sample] in [0, 1)^2, the same for every pixel
/// out    : hits[(sample * row_count + row - first_row) * width + x]; disparity = 1 / depth along the optical axis
/// clip   : nothing is there before the camera's near distance, as in Mitsuba; hits beyond its far distance are dropped
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void rasterize_film(global const Triangle *triangles, int triangle_count,
                                                                          global const float4 *planes, Camera camera,
                                                                          global const float4 *bounds, global const float2 *offsets,
                                                                          int sample_count, int first_row, int row_count, int band,
                                                                          global Hit *hits) {
    int item = get_global_id(0);
    int bands = (row_count + band - 1) / band;
    if (item >= bands * sample_count) return;
    int sample = item / bands;
    int top = (item % bands) * band;
    int bottom = min(top + band, row_count);
    float2 offset = offsets[sample];
    RasterFrame frame = {camera.corner + offset.x * camera.step_x + (offset.y + first_row) * camera.step_y, camera.step_x, camera.step_y};
    global Hit *image = hits + (size_t)sample * row_count * camera.width;
    for (int i = top * camera.width; i < bottom * camera.width; ++i) {
        image[i].triangle = -1;
        image[i].disparity = 0.0f;
    }
    float4 eye = (float4)(camera.origin.xyz, 0.0f);
    float nearest = camera.near_clip > 0.0f ? 1.0f / camera.near_clip : INFINITY;
    for (int i = 0; i < triangle_count; ++i) {
        // Sample x of pixel column k lies at k + offset; raster_range counts centres at k + 1/2.
        float4 box = bounds[i] + (float4)(0.5f - offset, 0.5f - offset) - (float4)(0.0f, first_row, 0.0f, first_row);
        if (!(box.w >= top - FILM_SLACK && box.y <= bottom + FILM_SLACK)) continue;
        int2 ys = raster_range(box.y, box.w, FILM_SLACK, bottom - 1);
        if (ys.y < top || ys.x > ys.y) continue;
        int2 xs = raster_range(box.x, box.z, FILM_SLACK, camera.width - 1);
        if (xs.x > xs.y) continue;
        global const Triangle *triangle = triangles + i;
        float4 plane = planes[triangle->plane];
        float4 p[3] = {triangle->v0 - eye, triangle->v1 - eye, triangle->v2 - eye};
        RasterTriangle t = raster_setup(p[0], p[1], p[2], plane, plane_ahead(plane, eye), frame);
        for (int y = max(ys.x, top); y <= ys.y; ++y) raster_row(&t, i, 0.0f, 1.0f, (float)y, xs.x, xs.y, nearest, image + y * camera.width);
    }
    float farthest = 1.0f / camera.far_clip;
    for (int i = top * camera.width; i < bottom * camera.width; ++i)
        if (image[i].disparity < farthest) image[i].triangle = -1;
}
