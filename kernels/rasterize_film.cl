// What the camera sees, by the core of the octahedral rasteriser: the film is one more linear projection.

/// Slack of the bounding box [pixels], and the depth below which a corner is clipped before it is projected.
#define FILM_SLACK 1e-2f
#define FILM_NEAREST 1e-6f

/// Bounds of the projection of the part of a triangle (corners relative to the pinhole) in front of it: (min px, min py, max px, max py).
/// `to_film` rows give px, py and depth of a point as (row0 . p) / (row2 . p), (row1 . p) / (row2 . p), row2 . p.
inline float4 film_bounds(const float4 *p, const float4 *to_film) {
    float4 bounds = (float4)(INFINITY, INFINITY, -INFINITY, -INFINITY);
    for (int i = 0; i < 3; ++i) {
        float4 a = p[i];
        float4 b = p[i < 2 ? i + 1 : 0];
        float da = dot(to_film[2].xyz, a.xyz);
        float db = dot(to_film[2].xyz, b.xyz);
        if (da >= FILM_NEAREST) {
            float2 q = (float2)(dot(to_film[0].xyz, a.xyz), dot(to_film[1].xyz, a.xyz)) / da;
            bounds = (float4)(fmin(bounds.xy, q), fmax(bounds.zw, q));
        }
        if ((da >= FILM_NEAREST) != (db >= FILM_NEAREST)) {
            float4 c = a + (b - a) * ((FILM_NEAREST - da) / (db - da));
            float2 q = (float2)(dot(to_film[0].xyz, c.xyz), dot(to_film[1].xyz, c.xyz)) / FILM_NEAREST;
            bounds = (float4)(fmin(bounds.xy, q), fmax(bounds.zw, q));
        }
    }
    return bounds;
}

/// Renders the scene at `sample_count` positions inside every pixel of a strip of rows.
/// launch : 1-D, one work-item per (sample, band of `band` rows)
/// in     : triangles, planes; camera; to_film[3] (see film_bounds); offsets[sample] in [0, 1)^2, the same for every pixel
/// out    : hits[(sample * row_count + row - first_row) * width + x]; disparity = 1 / depth along the optical axis
/// clip   : nothing is there before the camera's near distance, as in Mitsuba; hits beyond its far distance are dropped
kernel void rasterize_film(global const Triangle *triangles, int triangle_count, global const float4 *planes, Camera camera,
                           global const float4 *to_film, global const float2 *offsets, int sample_count, int first_row, int row_count,
                           int band, global Hit *hits) {
    int item = get_global_id(0);
    int bands = (row_count + band - 1) / band;
    if (item >= bands * sample_count) return;
    int sample = item / bands;
    int top = (item % bands) * band;
    int bottom = min(top + band, row_count);
    float2 offset = offsets[sample];
    RasterFrame frame = {camera.corner + offset.x * camera.step_x + (offset.y + first_row) * camera.step_y, camera.step_x, camera.step_y};
    float4 rows[3] = {to_film[0], to_film[1], to_film[2]};
    global Hit *image = hits + (size_t)sample * row_count * camera.width;
    for (int i = top * camera.width; i < bottom * camera.width; ++i) {
        image[i].triangle = -1;
        image[i].disparity = 0.0f;
    }
    float4 eye = (float4)(camera.origin.xyz, 0.0f);
    float nearest = camera.near_clip > 0.0f ? 1.0f / camera.near_clip : INFINITY;
    for (int i = 0; i < triangle_count; ++i) {
        global const Triangle *triangle = triangles + i;
        float4 p[3] = {triangle->v0 - eye, triangle->v1 - eye, triangle->v2 - eye};
        float4 bounds = film_bounds(p, rows);
        // Sample x of pixel column k lies at k + offset; raster_range counts centres at k + 1/2.
        float2 shift = 0.5f - offset;
        int2 ys = raster_range(bounds.y + shift.y - first_row, bounds.w + shift.y - first_row, FILM_SLACK, bottom - 1);
        if (ys.y < top || ys.x > ys.y) continue;
        int2 xs = raster_range(bounds.x + shift.x, bounds.z + shift.x, FILM_SLACK, camera.width - 1);
        if (xs.x > xs.y) continue;
        float4 plane = planes[triangle->plane];
        float ahead = plane_ahead(plane, eye);
        if (fabs(ahead) < PLANE_TOLERANCE) continue;
        RasterTriangle t = raster_setup(p[0], p[1], p[2], plane, ahead, frame);
        for (int y = max(ys.x, top); y <= ys.y; ++y) raster_row(&t, i, 0.0f, 1.0f, (float)y, xs.x, xs.y, nearest, image + y * camera.width);
    }
    float farthest = 1.0f / camera.far_clip;
    for (int i = top * camera.width; i < bottom * camera.width; ++i)
        if (image[i].disparity < farthest) image[i].triangle = -1;
}
