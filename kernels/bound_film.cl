// Where on the film each triangle may be seen: found once for all visibility samples.

#include "lib/triangle.cl"
#include "shared/camera.h"
#include "shared/geometry.h"

/// Bounds of the projection of the part of a triangle (corners relative to the pinhole) that is further in front of it than `nearest`:
/// (min px, min py, max px, max py).
/// `to_film` rows give px, py and depth of a point as (row0 . p) / (row2 . p), (row1 . p) / (row2 . p), row2 . p.
static inline float4 film_bounds(const float4 *p, const float4 *to_film, float nearest) {
    float4 bounds = (float4)(INFINITY, INFINITY, -INFINITY, -INFINITY);
    for (int i = 0; i < 3; ++i) {
        float4 a = p[i];
        float4 b = p[i < 2 ? i + 1 : 0];
        float da = dot(to_film[2].xyz, a.xyz);
        float db = dot(to_film[2].xyz, b.xyz);
        if (da >= nearest) {
            float2 q = (float2)(dot(to_film[0].xyz, a.xyz), dot(to_film[1].xyz, a.xyz)) / da;
            bounds = (float4)(fmin(bounds.xy, q), fmax(bounds.zw, q));
        }
        if ((da >= nearest) != (db >= nearest)) {
            float4 c = a + (b - a) * ((nearest - da) / (db - da));
            float2 q = (float2)(dot(to_film[0].xyz, c.xyz), dot(to_film[1].xyz, c.xyz)) / nearest;
            bounds = (float4)(fmin(bounds.xy, q), fmax(bounds.zw, q));
        }
    }
    return bounds;
}

/// launch : 1-D, one work-item per triangle
/// in     : triangles, planes; camera; to_film[3] (film_bounds)
/// out    : bounds[triangle]: min px, min py, max px, max py [pixels]; empty if the pinhole lies in its plane
kernel void bound_film(global const Triangle *triangles, int triangle_count, global const float4 *planes, Camera camera,
                       global const float4 *to_film, global float4 *bounds) {
    int i = get_global_id(0);
    if (i >= triangle_count) return;
    global const Triangle *triangle = triangles + i;
    float4 eye = (float4)(camera.origin.xyz, 0.0f);
    float4 p[3] = {triangle->v0 - eye, triangle->v1 - eye, triangle->v2 - eye};
    float4 rows[3] = {to_film[0], to_film[1], to_film[2]};
    float4 far = fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2])));
    float tolerance = PLANE_TOLERANCE * fmin(fmax(far.x, fmax(far.y, far.z)), 1.0f);
    bool edge_on = fabs(plane_ahead(planes[triangle->plane], eye)) < tolerance;
    bounds[i] = edge_on ? (float4)(INFINITY, INFINITY, -INFINITY, -INFINITY) : film_bounds(p, rows, tolerance);
}
