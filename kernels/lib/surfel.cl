// Builds one surfel from a hit.

#include "lib/brdf.cl"
#include "lib/triangle.cl"
#include "shared/geometry.h"
#include "shared/material.h"
#include "shared/surfel.h"

/// Barycentric weights of the line through `cop` along `direction`, from the rasteriser's own edge functions.
static inline float3 hit_barycentric(global const Triangle *t, float4 cop, float4 direction) {
    float4 a = t->v0 - cop, b = t->v1 - cop, c = t->v2 - cop;
    float3 e = (float3)(dot(edge_normal(b, c).xyz, direction.xyz), dot(edge_normal(c, a).xyz, direction.xyz),
                        dot(edge_normal(a, b).xyz, direction.xyz));
    return e / (e.x + e.y + e.z);
}

/// omega_o (brdf.cl) of a surface with normal n that is seen along `towards`, for models whose albedo depends on its height alone.
static inline float3 seen_from(float3 n, float3 towards) {
    float z = clamp(dot(n, towards), 0.0f, 1.0f);
    return (float3)(sqrt(1.0f - z * z), 0.0f, z);
}

/// Writes surfel `i` of a buffer of `capacity` surfels: what the ray from `cop` along `direction` meets at 1 / hit.disparity.
static inline void write_surfel(global float *surfels, int capacity, int i, Hit hit, float4 cop, float4 direction,
                         global const Triangle *triangles, global const float4 *planes, global const Material *materials,
                         global const float4 *normals) {
    global float *s = surfels + i;
    if (hit.triangle < 0) {
        for (int f = 0; f < SURFEL_FIELDS_WITH(PENCIL_OUTGOING); ++f) s[(size_t)f * capacity] = 0.0f;
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
    global const Material *material = materials + t->material;
    float reflects = front || material->albedo.w != 0.0f ? 1.0f : 0.0f;
    float3 towards = PENCIL_OUTGOING ? -normalize(direction.xyz) : n;  // no model looks at it if it is not carried
    float3 albedo = brdf_albedo(material, seen_from(n, towards));
    float values[SURFEL_FIELDS] = {p.x,
                                   p.y,
                                   p.z,
                                   n.x,
                                   n.y,
                                   n.z,
                                   as_float(t->plane),
                                   reflects * albedo.x,
                                   reflects * albedo.y,
                                   reflects * albedo.z,
                                   as_float(front ? t->material : ~t->material),
                                   g.x,
                                   g.y,
                                   g.z};
    for (int f = 0; f < SURFEL_FIELDS; ++f) s[(size_t)f * capacity] = values[f];
    if (!PENCIL_OUTGOING) return;
    s[(size_t)SURFEL_OX * capacity] = towards.x;
    s[(size_t)SURFEL_OY * capacity] = towards.y;
    s[(size_t)SURFEL_OZ * capacity] = towards.z;
}
