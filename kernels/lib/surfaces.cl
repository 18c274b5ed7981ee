// The scene as surfaces: where a ray meets one, its normals and what it does with light.

#include "lib/bsdf.cl"
#include "lib/hash.cl"
#include "lib/packet.cl"
#include "lib/texture.cl"
#include "lib/triangle.cl"
#include "shared/geometry.h"
#include "shared/material.h"
#include "shared/surfel.h"
#include "shared/texture.h"

/// Parameters of kernels, the same as arguments, and as one value. Three normals and three texture coordinates for each triangle, if any have them.
#define SURFACES_PARAMETERS                                                                                                        \
    global const Triangle *triangles, global const float4 *planes, global const Material *materials, global const float4 *normals, \
        global const float2 *uvs, global const TextureRow *textures, global const half *bitmaps
#define SURFACES_ARGUMENTS triangles, planes, materials, normals, uvs, textures, bitmaps
#define SURFACES \
    { triangles, planes, materials, normals, uvs, textures, bitmaps }

typedef struct Surfaces {
    global const Triangle *triangles;
    global const float4 *planes;
    global const Material *materials;
    global const float4 *normals;
    global const float2 *uvs;
    global const TextureRow *textures;
    global const half *bitmaps;
} Surfaces;

/// A point of a surface as it is seen.
typedef struct Vertex {
    float3 x;       // [scene units]
    float3 n, g;    // unit shading and geometric normal on the side that was seen
    float3 o;       // unit direction to where it was seen from
    float3 albedo;  // of the base
#if PENCIL_GLOW
    float3 emission;  // of the side that was seen [W m^-2 sr^-1]
#endif
    int plane;  // -1: nothing was met
    int row;    // of materials; ~row if the back was seen
    Bsdf bsdf;
} Vertex;

/// Barycentric weights of the line through `cop` along `direction`, from the rasteriser's own edge functions.
static inline float3 hit_barycentric(global const Triangle *t, float4 cop, float4 direction) {
    float4 a = t->v0 - cop, b = t->v1 - cop, c = t->v2 - cop;
    float3 e = (float3)(dot(edge_normal(b, c).xyz, direction.xyz), dot(edge_normal(c, a).xyz, direction.xyz),
                        dot(edge_normal(a, b).xyz, direction.xyz));
    return e / (e.x + e.y + e.z);
}

/// Index of the row that scatters light at a point: the side's own, and one of those that a blend chooses from, by `bits` that differ from point to point.
static inline int scattering_row(const Surfaces *s, int row, bool front, const TexturePoint *at, uint bits) {
    if (PENCIL_BLENDS && !front && s->materials[row].back >= 0) row = s->materials[row].back;
    while (PENCIL_BLENDS && s->materials[row].model == MATERIAL_BLEND) {
        bits = hash_uint(bits);
        global const Material *m = s->materials + row;
        float4 value = texture_or_one(m->weight_texture, s->textures, s->bitmaps, at);
        float weight = m->weight * (m->flags & MATERIAL_OPACITY ? value.w : value.x);
        row = (bits >> UNIT_SHIFT) * UNIT_STEP < weight ? m->second : m->first;
    }
    return row;
}

/// Index of the far side over that of the near side: a back has it the other way round, but the backs of plastics and metals are as their fronts.
static inline float3 side_index(global const Material *m, bool front) {
    bool turns = m->model == MATERIAL_DIELECTRIC || (m->model == MATERIAL_PRINCIPLED && m->parameters[1] > 0.0f);
    return front || !turns || m->flags & MATERIAL_THIN ? m->eta.xyz : 1.0f / m->eta.xyz;
}

/// Parameters of the row at a point that is seen from the front or from the back.
static inline Bsdf bsdf_at(const Surfaces *s, int row, bool front, const TexturePoint *at) {
    global const Material *m = s->materials + row;
    Bsdf b = {m->model, m->flags,   m->albedo.xyz, m->specular.xyz,  m->transmitted.xyz, m->eta.xyz,       m->k.xyz, m->specular.w,
              m->eta.w, m->varnish, s->bitmaps,    m->parameters[0], m->parameters[1],   m->parameters[2], m->gloss};
    if (PENCIL_TEXTURES) {
        b.albedo *= texture_or_one(m->albedo_texture, s->textures, s->bitmaps, at).xyz;
        b.specular *= texture_or_one(m->specular_texture, s->textures, s->bitmaps, at).xyz;
        b.alpha *= texture_or_one(m->alpha_texture, s->textures, s->bitmaps, at).x;
        b.metallic *= texture_or_one(m->metallic_texture, s->textures, s->bitmaps, at).x;
    }
    if (PENCIL_MODEL_PRINCIPLED && m->model == MATERIAL_PRINCIPLED) {
        b.specular = b.albedo;
        b.alpha = fmax(b.alpha * b.alpha, 1e-3f);  // of its roughness
    }
    b.eta = side_index(m, front);
    return b;
}

/// Derivatives of the position by u and v on a triangle, and its texture coordinates' area; 0: it has none.
static inline float uv_tangents(const Surfaces *s, int triangle, float3 *du, float3 *dv) {
    global const Triangle *t = s->triangles + triangle;
    global const float2 *uv = s->uvs + 3 * (size_t)triangle;
    float3 p = (t->v1 - t->v0).xyz, q = (t->v2 - t->v0).xyz;
    float2 a = uv[1] - uv[0], b = uv[2] - uv[0];
    float area = a.x * b.y - a.y * b.x;
    *du = (b.y * p - a.y * q) / area;
    *dv = (a.x * q - b.x * p) / area;
    return area;
}

/// The shading normal n of the front, turned by the relief of material m (Blinn 1978; normals in the frame of u, and of v where the material says so).
static inline float3 relief_normal(const Surfaces *s, global const Material *m, const TexturePoint *at, float3 n) {
    float3 du, dv;
    if (m->normal_texture < 0 || uv_tangents(s, at->triangle, &du, &dv) == 0.0f) return n;
    global const TextureRow *t = s->textures + m->normal_texture;
    float3 relief;
    if (m->flags & MATERIAL_BUMP) {
        float2 slope = m->transmitted.w * texture_slope(t, s->bitmaps, at);
        du += (slope.x - dot(n, du)) * n;
        dv += (slope.y - dot(n, dv)) * n;
        relief = cross(du, dv);
    } else {
        float3 turned = 2.0f * texture_value(t, s->bitmaps, at).xyz - 1.0f, tangent = du - dot(n, du) * n;
        if (!(dot(tangent, tangent) > 0.0f)) return n;
        tangent = normalize(tangent);
        float3 bitangent = cross(n, tangent);
        if (m->flags & MATERIAL_Y_UP && dot(bitangent, dv) > 0.0f) turned.y = -turned.y;
        relief = turned.x * tangent + turned.y * bitangent + turned.z * n;
    }
    float square = dot(relief, relief);
    if (!(square > 0.0f)) return n;
    relief *= rsqrt(square);
    return dot(relief, n) < 0.0f ? -relief : relief;
}

/// omega_o (bsdf.cl) of a surface with normal n that is seen along `towards`, up to its azimuth.
static inline float3 seen_from(float3 n, float3 towards) {
    float z = clamp(dot(n, towards), 1e-4f, 1.0f);
    return (float3)(sqrt(1.0f - z * z), 0.0f, z);
}

/// True if light that meets this side is scattered.
static inline bool side_scatters(global const Material *m, bool front) {
    if (front || m->albedo.w != 0.0f) return true;
    return m->model == MATERIAL_DIELECTRIC || m->model == MATERIAL_PASS || (m->model == MATERIAL_PRINCIPLED && m->parameters[1] > 0.0f);
}

/// A point of a triangle at barycentric weights w.
static inline TexturePoint texture_point(const Surfaces *s, int triangle, float3 w) {
    TexturePoint at = {(float2)(0.0f), w, triangle};
    if (PENCIL_TEXTURES) {
        global const float2 *uv = s->uvs + 3 * (size_t)triangle;
        at.uv = w.x * uv[0] + w.y * uv[1] + w.z * uv[2];
    }
    return at;
}

/// Emitted radiance of the front of material m at a point [W m^-2 sr^-1].
static inline float3 emission_at(const Surfaces *s, global const Material *m, const TexturePoint *at) {
    if (!PENCIL_GLOW || m->emission_texture < 0) return m->emission.xyz;
    return m->glow.xyz * texture_value(s->textures + m->emission_texture, s->bitmaps, at).xyz;
}

/// What the ray from `cop` along `direction` meets on triangle hit.triangle >= 0, at 1 / hit.disparity; bits: random, for blends.
static inline Vertex meet_surface(const Surfaces *s, Hit hit, float4 cop, float4 direction, uint bits) {
    global const Triangle *t = s->triangles + hit.triangle;
    float4 plane = s->planes[t->plane];
    bool front = plane_ahead(plane, cop) < 0.0f;  // the plane lies behind its own normal as seen from the centre
    Vertex v;
    v.x = (cop + direction / hit.disparity).xyz;
    v.plane = t->plane;
    v.g = front ? plane.xyz : -plane.xyz;
    v.n = v.g;
    float3 w = PENCIL_SMOOTH || PENCIL_TEXTURES ? hit_barycentric(t, cop, direction) : (float3)(0.0f);
    if (PENCIL_SMOOTH) {
        global const float4 *corner = s->normals + 3 * hit.triangle;
        float3 m = w.x * corner[0].xyz + w.y * corner[1].xyz + w.z * corner[2].xyz;
        if (dot(m, m) > 0.0f) v.n = normalize(front ? m : -m);
    }
    TexturePoint at = texture_point(s, hit.triangle, w);
#if PENCIL_GLOW
    v.emission = front ? emission_at(s, s->materials + t->material, &at) : (float3)(0.0f);
#endif
    int row = scattering_row(s, t->material, front, &at, bits);
    if (PENCIL_RELIEF) v.n = front ? relief_normal(s, s->materials + row, &at, v.n) : -relief_normal(s, s->materials + row, &at, -v.n);
    v.row = front ? row : ~row;
    v.o = PENCIL_LOBES || PENCIL_SKY ? -normalize(direction.xyz) : v.n;  // no model looks at it if it is not carried
    // Seen from below its shading normal: relief is black there, as Mitsuba's; others are as flat.
    global const Material *m = s->materials + row;
    bool black = PENCIL_RELIEF && m->normal_texture >= 0 && m->model != MATERIAL_DIELECTRIC && dot(v.n, direction.xyz) >= 0.0f;
    if ((PENCIL_OUTGOING || PENCIL_RELIEF) && dot(v.n, direction.xyz) >= 0.0f) v.n = v.g;
    v.bsdf = bsdf_at(s, row, front, &at);
    float3 omega_o = seen_from(v.n, v.o);
    v.albedo = bsdf_base(&v.bsdf, omega_o);
    if (!PENCIL_LOBES) v.albedo += bsdf_share(&v.bsdf, omega_o);  // lobes as if they were even
    if (black || !side_scatters(m, front)) {
        v.albedo = (float3)(0.0f);
        v.bsdf.model = MATERIAL_DIFFUSE;
    }
    return v;
}

/// The same where nothing was met.
static inline Vertex meet_nothing(float3 direction) {
    Vertex v;
    v.x = v.n = v.g = v.albedo = (float3)(0.0f);
#if PENCIL_GLOW
    v.emission = (float3)(0.0f);
#endif
    v.o = -normalize(direction);
    v.plane = -1;
    v.row = PENCIL_NO_MATERIAL;
    v.bsdf.model = MATERIAL_DIFFUSE;
    return v;
}
