// Whether light reaches points: rays to it meet nothing, or only what lets a share of it through unturned.

#include "lib/rays.cl"
#include "lib/surfaces.cl"

/// Surfaces that one ray passes at most.
#define SHADOW_MOST_PASSED 32

#if PENCIL_CLEAR
/// Share of light that passes a row that is no blend unturned, at this cosine to its normal.
static inline float row_share(global const Material *m, float cosine) {
    if (m->model == MATERIAL_PASS) return 1.0f;
    if (m->model != MATERIAL_DIELECTRIC || !(m->flags & MATERIAL_THIN)) return 0.0f;
    float refracted, reflected = fresnel_dielectric(cosine, m->eta.x, &refracted);
    float3 tint = m->transmitted.xyz;  // DEVIATION: colours of panes count by their mean here
    return (1.0f - 2.0f * reflected / (1.0f + reflected)) * (tint.x + tint.y + tint.z) * (1.0f / 3.0f);
}

/// Share of light that passes the triangle unturned, where it comes from `origin` along `direction`; bits: random, for blends of blends.
static inline float straight_share(const Surfaces *s, int triangle, float3 origin, float3 direction, uint bits) {
    global const Triangle *t = s->triangles + triangle;
    if (!(s->materials[t->material].flags & MATERIAL_CLEAR)) return 0.0f;
    float4 cop = (float4)(origin, 0.0f), way = (float4)(direction, 0.0f), plane = s->planes[t->plane];
    TexturePoint at = texture_point(s, triangle, hit_barycentric(t, cop, way));
    bool front = plane_ahead(plane, cop) < 0.0f;
    float3 n = plane.xyz;
    if (PENCIL_SMOOTH) {
        global const float4 *corner = s->normals + 3 * triangle;
        float3 turned = at.w.x * corner[0].xyz + at.w.y * corner[1].xyz + at.w.z * corner[2].xyz;
        if (dot(turned, turned) > 0.0f) n = normalize(turned);
    }
    float cosine = fabs(dot(n, normalize(direction)));
    global const Material *m = s->materials + t->material;
    if (m->model != MATERIAL_BLEND || (!front && m->back >= 0))
        return row_share(s->materials + scattering_row(s, t->material, front, &at, bits), cosine);
    float4 value = texture_or_one(m->weight_texture, s->textures, s->bitmaps, &at);
    float weight = clamp(m->weight * (m->flags & MATERIAL_OPACITY ? value.w : value.x), 0.0f, 1.0f);
    int first = scattering_row(s, m->first, front, &at, bits), second = scattering_row(s, m->second, front, &at, bits);
    return mix(row_share(s->materials + first, cosine), row_share(s->materials + second, cosine), weight);
}

/// The share of light that open rays let through to their ends; 0 for the others.
static inline vfloat lanes_share(LaneRays *r, const Surfaces *s, HIERARCHY_PARAMETERS) {
    int open = PACKET_BITS(PACKET_MASK(r->nearest > 0.0f));
    float share[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) share[l] = open >> l & 1 ? 1.0f : 0.0f;
    for (int passed = 0; open; ++passed) {
        vfloat end = r->nearest;
        lanes_trace(r, false, nodes, leaves, s->triangles, s->planes);
        float o[3][PENCIL_WIDTH], rest[PENCIL_WIDTH];
        int own[PENCIL_WIDTH];
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            int triangle = LANE_INT(r->triangle, l);
            float3 origin = (float3)(LANE_FLOAT(r->ox, l), LANE_FLOAT(r->oy, l), LANE_FLOAT(r->oz, l));
            float3 direction = (float3)(LANE_FLOAT(r->x, l), LANE_FLOAT(r->y, l), LANE_FLOAT(r->z, l));
            rest[l] = -1.0f;
            own[l] = -1;
            if (open >> l & 1 && triangle >= 0) {
                float met = LANE_FLOAT(r->nearest, l);
                uint bits = hash_uint(as_uint(origin.x) ^ hash_uint(as_uint(origin.y) ^ hash_uint(as_uint(direction.x) + triangle)));
                share[l] *= passed < SHADOW_MOST_PASSED ? straight_share(s, triangle, origin, direction, bits) : 0.0f;
                if (share[l] > 0.0f) {
                    rest[l] = LANE_FLOAT(end, l) - met;
                    own[l] = s->triangles[triangle].plane;
                    origin += met * direction;
                }
            }
            if (!(rest[l] > 0.0f)) open &= ~(1 << l);
            o[0][l] = origin.x;
            o[1][l] = origin.y;
            o[2][l] = origin.z;
        }
        *r = lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), r->x, r->y, r->z, PACKET_LOAD(own), PACKET_LOAD(rest));
    }
    return PACKET_LOAD(share);
}
#endif

/// The share of light that rays of the lanes `open` let through to their ends: 1 or 0 where no material is clear; `scene` is looked at only there.
static inline vfloat rays_share(LaneRays *r, int open, const Surfaces *scene, HIERARCHY_PARAMETERS, global const Triangle *triangles,
                                global const float4 *planes) {
#if PENCIL_CLEAR
    return lanes_share(r, scene, nodes, leaves);
#else
    lanes_trace(r, true, nodes, leaves, triangles, planes);
    return select((vfloat)(0.0f), (vfloat)(1.0f), PACKET_FROM_BITS(open) & PACKET_MASK(r->triangle < 0));
#endif
}
