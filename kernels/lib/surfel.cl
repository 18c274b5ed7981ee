// Builds one surfel from a hit.

#include "lib/triangle.cl"
#include "shared/geometry.h"
#include "shared/surfel.h"

/// Barycentric weights of the line through `cop` along `direction`, from the rasteriser's own edge functions.
static inline float3 hit_barycentric(global const Triangle *t, float4 cop, float4 direction) {
    float4 a = t->v0 - cop, b = t->v1 - cop, c = t->v2 - cop;
    float3 e = (float3)(dot(edge_normal(b, c).xyz, direction.xyz), dot(edge_normal(c, a).xyz, direction.xyz),
                        dot(edge_normal(a, b).xyz, direction.xyz));
    return e / (e.x + e.y + e.z);
}

/// Writes surfel `i` of a buffer of `capacity` surfels: what the ray from `cop` along `direction` meets at 1 / hit.disparity.
static inline void write_surfel(global float *surfels, int capacity, int i, Hit hit, float4 cop, float4 direction,
                         global const Triangle *triangles, global const float4 *planes, global const Material *materials,
                         global const float4 *normals) {
    global float *s = surfels + i;
    if (hit.triangle < 0) {
        for (int f = 0; f < SURFEL_FIELDS; ++f) s[(size_t)f * capacity] = 0.0f;
        s[(size_t)SURFEL_PLANE * capacity] = as_float(-1);
        s[(size_t)SURFEL_MATERIAL * capacity] = as_float(PENCIL_NO_MATERIAL);
        return;
    }
    global const Triangle *t = triangles + hit.triangle;
    float4 plane = planes[t->plane];
    float4 p = cop + direction / hit.disparity;
    bool front = plane_ahead(plane, cop) < 0.0f;  // the plane lies behind its own normal as seen from the centre
    float3 g = front ? plane.xyz : -plane.xyz;
    float3 n = g;
    if (PENCIL_SMOOTH) {
        float3 w = hit_barycentric(t, cop, direction);
        global const float4 *corner = normals + 3 * hit.triangle;
        float3 m = w.x * corner[0].xyz + w.y * corner[1].xyz + w.z * corner[2].xyz;
        if (dot(m, m) > 0.0f) n = normalize(front ? m : -m);
    }
    Material material = materials[t->material];
    float reflects = front || material.albedo.w != 0.0f ? 1.0f : 0.0f;
    float values[SURFEL_FIELDS] = {p.x,
                                   p.y,
                                   p.z,
                                   n.x,
                                   n.y,
                                   n.z,
                                   as_float(t->plane),
                                   reflects * material.albedo.x,
                                   reflects * material.albedo.y,
                                   reflects * material.albedo.z,
                                   as_float(front ? t->material : ~t->material),
                                   g.x,
                                   g.y,
                                   g.z};
    for (int f = 0; f < SURFEL_FIELDS; ++f) s[(size_t)f * capacity] = values[f];
}
