// Surfels in memory (shared/surfel.h).

#include "lib/surfaces.cl"
#include "shared/geometry.h"
#include "shared/surfel.h"

/// What a surfel says of the chain of lobes through which it is seen.
typedef struct Throughput {
    float3 factor;
    float share;  // SURFEL_SHARE
} Throughput;

/// Writes surfel `i` of a buffer of `capacity` surfels.
static inline void store_vertex(global float *surfels, int capacity, int i, const Vertex *v, Throughput t) {
    global float *s = surfels + i;
    size_t c = capacity;
    float3 albedo = PENCIL_OUTGOING ? v->albedo * t.factor : v->albedo;
    float values[SURFEL_FIELDS] = {v->x.x,   v->x.y,   v->x.z,   v->n.x, v->n.y, v->n.z, 0.0f,
                                   albedo.x, albedo.y, albedo.z, 0.0f,   v->g.x, v->g.y, v->g.z};
    for (int f = 0; f < SURFEL_FIELDS; ++f)
        if (f != SURFEL_PLANE && f != SURFEL_MATERIAL) s[f * c] = values[f];
    SURFEL_INT(s, SURFEL_PLANE * c) = v->plane;
    SURFEL_INT(s, SURFEL_MATERIAL * c) = v->row;
    if (!PENCIL_OUTGOING) return;
    bool lobes = v->bsdf.model != MATERIAL_DIFFUSE;
    float3 specular = lobes ? v->bsdf.specular : (float3)(0.0f);
    float more[SURFEL_FIELDS_OUTGOING - SURFEL_FIELDS] = {v->o.x,
                                                          v->o.y,
                                                          v->o.z,
                                                          t.factor.x,
                                                          t.factor.y,
                                                          t.factor.z,
                                                          t.share,
                                                          specular.x,
                                                          specular.y,
                                                          specular.z,
                                                          lobes ? v->bsdf.alpha : -1.0f,
                                                          lobes ? v->bsdf.metallic : 0.0f};
    for (int f = 0; f < SURFEL_FIELDS_OUTGOING - SURFEL_FIELDS; ++f) s[(SURFEL_FIELDS + f) * c] = more[f];
#if PENCIL_GLOW
    s[SURFEL_ER * c] = v->emission.x;
    s[SURFEL_EG * c] = v->emission.y;
    s[SURFEL_EB * c] = v->emission.z;
#endif
}

/// Writes surfel `i`: what the ray from `cop` along `direction` meets at 1 / hit.disparity; bits: random, for blends.
static inline void write_surfel(global float *surfels, int capacity, int i, Hit hit, float4 cop, float4 direction, const Surfaces *scene,
                                uint bits) {
    Throughput all = {(float3)(1.0f), -1.0f};
    Vertex v = hit.triangle < 0 ? meet_nothing(direction.xyz) : meet_surface(scene, hit, cop, direction, bits);
    store_vertex(surfels, capacity, i, &v, all);
}

static inline float3 surfel_vector(global const float *surfels, size_t capacity, int i, int field) {
    global const float *s = surfels + i;
    return (float3)(s[field * capacity], s[(field + 1) * capacity], s[(field + 2) * capacity]);
}

/// The surfel as it was stored; the albedo holds the throughput. tables: texels of textures. Needs PENCIL_OUTGOING.
static inline Vertex load_vertex(global const float *surfels, size_t capacity, int i, global const Material *materials,
                                 global const half *tables) {
    Vertex v;
    v.x = surfel_vector(surfels, capacity, i, SURFEL_X);
    v.n = surfel_vector(surfels, capacity, i, SURFEL_NX);
    v.g = surfel_vector(surfels, capacity, i, SURFEL_GX);
    v.o = surfel_vector(surfels, capacity, i, SURFEL_OX);
    v.albedo = surfel_vector(surfels, capacity, i, SURFEL_ALBEDO_R);
#if PENCIL_GLOW
    v.emission = surfel_vector(surfels, capacity, i, SURFEL_ER);
#endif
    v.plane = SURFEL_CONST_INT(surfels, SURFEL_PLANE * capacity + i);
    v.row = SURFEL_CONST_INT(surfels, SURFEL_MATERIAL * capacity + i);
    v.bsdf.model = MATERIAL_DIFFUSE;
    if (v.plane < 0 || v.row == PENCIL_NO_MATERIAL) return v;
    bool front = v.row >= 0;
    global const Material *m = materials + (front ? v.row : ~v.row);
    // Facets of a relief that face away are black, whatever their material.
    if (!side_scatters(m, front) || surfels[SURFEL_ALPHA * capacity + i] < 0.0f) return v;
    Bsdf b = {m->model,
              m->flags,
              m->albedo.xyz,
              surfel_vector(surfels, capacity, i, SURFEL_SR),
              m->transmitted.xyz,
              side_index(m, front),
              m->k.xyz,
              surfels[SURFEL_ALPHA * capacity + i],
              m->eta.w,
              m->varnish,
              tables,
              surfels[SURFEL_METALLIC * capacity + i],
              m->parameters[1],
              m->parameters[2],
              m->gloss};
    v.bsdf = b;
    return v;
}
