// Light paths from surface points, estimates of reflected light that owe nothing to the methods that they check: no cache, no reuse, every
// vertex lit by one sample of the emitters and by what its own ray meets, combined by the balance heuristic (Veach 1997, 9.2), ended by
// Russian roulette without a bound below 1.

#include "lib/apart.cl"
#include "lib/bsdf.cl"
#include "lib/check_lights.cl"
#include "lib/hash.cl"
#include "lib/hemisphere.cl"
#include "lib/packet.cl"
#include "lib/rays.cl"
#include "lib/shadow.cl"
#include "lib/surfel.cl"
#include "shared/surfel.h"

/// Reflections after which a path may end.
#define CHECK_SURE_ORDERS 3
/// Where nothing is lost paths would never end. At an albedo of 0.995 less than a hundredth of the light is beyond.
#define CHECK_MOST_ORDERS 1024
/// Segments to emitters end this share before them.
#define CHECK_SHADOW_END 0.9999f

/// One path: where it is, what it carries.
typedef struct CheckPath {
    Vertex at;
    float3 throughput;  // without the scattering at this vertex; 0: it has ended
    float3 sum;
    uint bits;
    float3 from;  // the last vertex that turned the path
    float pdf;    // of the ray from there per solid angle [1/sr]; 0: of a lobe without width
} CheckPath;

static inline float check_random(CheckPath *p) {
    p->bits = hash_uint(p->bits);
    return (p->bits >> UNIT_SHIFT) * UNIT_STEP;
}

/// At the surfel that a path starts on.
static inline CheckPath begin_path(global const float *surfels, size_t capacity, int surfel, global const Material *materials,
                                   global const half *tables, uint bits) {
    CheckPath p;
    p.throughput = p.sum = p.from = (float3)(0.0f);
    p.bits = bits;
    p.pdf = 0.0f;
    p.at = meet_nothing((float3)(0.0f, 0.0f, 1.0f));
    if (surfel < 0 || SURFEL_CONST_INT(surfels, SURFEL_PLANE * capacity + surfel) < 0) return p;
    p.throughput = (float3)(1.0f);
    if (PENCIL_LOBES) {
        p.at = load_vertex(surfels, capacity, surfel, materials, tables);
        return p;
    }
    p.at.x = surfel_vector(surfels, capacity, surfel, SURFEL_X);
    p.at.n = p.at.o = surfel_vector(surfels, capacity, surfel, SURFEL_NX);
    p.at.g = surfel_vector(surfels, capacity, surfel, SURFEL_GX);
    p.at.albedo = surfel_vector(surfels, capacity, surfel, SURFEL_ALBEDO_R);
    p.at.plane = SURFEL_CONST_INT(surfels, SURFEL_PLANE * capacity + surfel);
    return p;
}

/// Chance with which a direction is drawn for the base of a vertex.
static inline float base_chance(const Vertex *v) {
    if (!PENCIL_LOBES || v->bsdf.model == MATERIAL_DIFFUSE) return 1.0f;
    float base = largest(v->albedo), lobes = largest(bsdf_share(&v->bsdf, seen_from(v->n, v->o)));
    return base + lobes > 0.0f ? base / (base + lobes) : 1.0f;
}

/// Scattering from a unit direction, times the cosine, and the density with which next_direction draws it.
static inline float3 scatter_from(const Vertex *v, float3 direction, float *density) {
    float cosine = dot(v->n, direction), up = fmax(cosine, 0.0f) * M_1_PI_F, chance = base_chance(v);
    *density = chance * up;
    bool above = dot(v->g, direction) > 0.0f;
    if (!PENCIL_LOBES || v->bsdf.model == MATERIAL_DIFFUSE) return above ? v->albedo * up : (float3)(0.0f);
    float3 t, b, omega_o = seen_from(v->n, v->o);
    frame_towards(v->n, v->o, &t, &b);
    float3 omega_i = (float3)(dot(direction, t), dot(direction, b), cosine);
    *density += (1.0f - chance) * bsdf_pdf(&v->bsdf, omega_o, omega_i);
    if (above != omega_i.z > 0.0f) return (float3)(0.0f);
    return v->albedo * (up * (up > 0.0f ? bsdf_base_factor(&v->bsdf, omega_o, omega_i) : 0.0f)) + bsdf_evaluate(&v->bsdf, omega_o, omega_i);
}

/// Radiance that the vertex sends back of it, by the balance heuristic.
static inline float3 scattered_light(const CheckPath *p, const Aim *a) {
    if (!any(a->light > 0.0f)) return (float3)(0.0f);
    float own;
    float3 f = p->throughput * scatter_from(&p->at, a->direction, &own);
    return f * a->light * (a->density > 0.0f ? 1.0f / (a->density + own) : 1.0f);
}

/// A direction for what the vertex scatters; the throughput takes that in. 0 if the path ends.
static inline float3 next_direction(CheckPath *p) {
    float pick = check_random(p), u = check_random(p), v = check_random(p), w = PENCIL_LOBES ? check_random(p) : 0.0f,
          chance = base_chance(&p->at);
    float3 t, b, direction;
    if (PENCIL_LOBES)
        frame_towards(p->at.n, p->at.o, &t, &b);
    else
        tangent_frame(p->at.n, &t, &b);
    if (pick < chance) {
        float radius = sqrt(u), phi = 2.0f * M_PI_F * v;
        direction = radius * cos(phi) * t + radius * sin(phi) * b + sqrt(1.0f - u) * p->at.n;
    } else {
        BsdfSample s = bsdf_sample(&p->at.bsdf, seen_from(p->at.n, p->at.o), (float3)(u, v, w));
        direction = s.omega_i.x * t + s.omega_i.y * b + s.omega_i.z * p->at.n;
        if (!any(s.weight > 0.0f)) {  // there is no direction
            p->throughput = (float3)(0.0f);
            return direction;
        }
        if (PENCIL_CLEAR && goes_straight(&p->at.bsdf, &s)) {
            p->throughput *= s.weight / (1.0f - chance);
            return direction;
        }
        p->from = p->at.x;
        if (s.pdf == 0.0f) {
            bool agrees = dot(direction, p->at.g) * s.omega_i.z > 0.0f;
            p->throughput *= agrees ? s.weight / (1.0f - chance) : (float3)(0.0f);
            p->pdf = 0.0f;
            return direction;
        }
    }
    p->from = p->at.x;
    float3 f = scatter_from(&p->at, direction, &p->pdf);
    p->throughput *= p->pdf > 0.0f ? f / p->pdf : (float3)(0.0f);
    return direction;
}

/// The path goes on at what its ray has met: takes its emission.
static inline void arrive(CheckPath *p, float3 direction, int triangle, float distance, const CheckLights *lights, const Surfaces *scene) {
    if (triangle < 0) {
        if (PENCIL_SKY) {
            float3 all = sky_texel(lights->sky, lights->sky_texels, direction);
            float size = luminance(all), low = fmin(lights->sky->limit / fmax(size, 1e-30f), 1.0f);
            float share = p->pdf > 0.0f ? low + (1.0f - low) * p->pdf / (p->pdf + sky_density(lights, size)) : 1.0f;
            p->sum += p->throughput * all * share;
        }
        p->throughput = (float3)(0.0f);
        return;
    }
    Hit hit = {triangle, 1.0f / distance};
    int row = scene->triangles[triangle].material;
    float3 mean = scene->materials[row].emission.xyz;
    float4 plane = scene->planes[scene->triangles[triangle].plane];
    float light_cosine = -dot(plane.xyz, direction);
    float3 segment = p->at.x + distance * direction - p->from;
    p->bits = hash_uint(p->bits);
    p->at = meet_surface(scene, hit, (float4)(p->at.x, 0.0f), (float4)(direction, 0.0f), p->bits);
    if (light_cosine > 0.0f && any(mean > 0.0f)) {
#if PENCIL_GLOW
        float3 emission = p->at.emission;
#else
        float3 emission = mean;
#endif
        float density = lights->densities[row] * dot(segment, segment) / light_cosine;
        p->sum += p->throughput * emission * (p->pdf > 0.0f ? p->pdf / (p->pdf + density) : 1.0f);
    }
}

/// Rays from the vertices along `directions` up to `end`; none where that is below 0.
static inline LaneRays rays_of_paths(const CheckPath *paths, const float3 *directions, const float *end) {
    float o[3][PENCIL_WIDTH], d[3][PENCIL_WIDTH];
    int own[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        o[0][l] = paths[l].at.x.x;
        o[1][l] = paths[l].at.x.y;
        o[2][l] = paths[l].at.x.z;
        d[0][l] = directions[l].x;
        d[1][l] = directions[l].y;
        d[2][l] = directions[l].z;
        own[l] = paths[l].at.plane;
    }
    return lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), PACKET_LOAD(d[0]), PACKET_LOAD(d[1]), PACKET_LOAD(d[2]),
                     PACKET_LOAD(own), PACKET_LOAD(end));
}

/// Light from one sample of the emitters to each path's vertex.
static inline void light_vertices(CheckPath *paths, const CheckLights *lights, const Surfaces *scene, HIERARCHY_PARAMETERS) {
    float3 light[PENCIL_WIDTH], segments[PENCIL_WIDTH];
    float end[PENCIL_WIDTH];
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        segments[l] = light[l] = (float3)(0.0f);
        end[l] = -1.0f;
        if (!any(paths[l].throughput > 0.0f)) continue;
        CheckPath *p = paths + l;
        float pick = check_random(p), u = check_random(p), v = check_random(p);
        Aim a = aim_check(p->at.x, (float3)(pick, u, v), lights, scene);
        segments[l] = a.segment;
        light[l] = scattered_light(paths + l, &a);
        if (any(light[l] > 0.0f)) end[l] = a.far ? INFINITY : CHECK_SHADOW_END;
    }
    LaneRays rays = rays_of_paths(paths, segments, end);
    vfloat share = rays_share(&rays, PACKET_BITS(PACKET_MASK(rays.nearest > 0.0f)), scene, nodes, leaves, scene->triangles, scene->planes);
    for (int l = 0; l < PENCIL_WIDTH; ++l) paths[l].sum += LANE_FLOAT(share, l) * light[l];
}

/// What a vertex scatters at most, to end paths by.
static inline float3 vertex_share(const Vertex *v) {
    if (!PENCIL_LOBES || v->bsdf.model == MATERIAL_DIFFUSE) return v->albedo;
    return fmin(v->albedo + bsdf_share(&v->bsdf, seen_from(v->n, v->o)), (float3)(1.0f));
}

/// Ends the path by Russian roulette, or gives it a direction. False if it has ended.
static inline bool go_on(CheckPath *p, int order, float3 *direction) {
    *direction = (float3)(0.0f);
    if (order > CHECK_SURE_ORDERS) {
        float survival = fmin(largest(p->throughput * vertex_share(&p->at)), 1.0f);
        p->throughput = survival > 0.0f && check_random(p) < survival ? p->throughput / survival : (float3)(0.0f);
    }
    if (any(p->throughput > 0.0f)) *direction = next_direction(p);
    return any(p->throughput > 0.0f);
}

/// Of the packet at `first`, see below.
APART static void trace_checks_packet(int first, global const float *surfels, int capacity, global const int *starts, int path_count,
                                      global const Emitter *emitters, int emitter_count, global const float *densities, float sky_density,
                                      SKY_PARAMETERS, int orders, uint seed, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS,
                                      global float *radiance) {
    CheckPath paths[PENCIL_WIDTH];
    CheckLights lights = {emitters, emitter_count, densities, sky_density, sky, sky_texels};
    Surfaces scene = SURFACES;
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l)
        paths[l] = begin_path(surfels, capacity, first + l < path_count ? starts[first + l] : -1, materials, bitmaps,
                              hash_uint(seed + hash_uint(first + l)));
    int most = orders < 0 ? CHECK_MOST_ORDERS : orders;
    for (int order = 1; order <= most; ++order) {
        if (emitter_count > 0) light_vertices(paths, &lights, &scene, nodes, leaves);
        float3 directions[PENCIL_WIDTH];
        float end[PENCIL_WIDTH];
        bool alive = false;
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            bool goes_on = go_on(paths + l, order, directions + l);
            end[l] = goes_on ? INFINITY : -1.0f;
            alive |= goes_on;
        }
        if (!alive) break;
        LaneRays rays = rays_of_paths(paths, directions, end);
        lanes_trace(&rays, false, nodes, leaves, triangles, planes);
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l)
            if (end[l] > 0.0f) arrive(paths + l, directions[l], LANE_INT(rays.triangle, l), LANE_FLOAT(rays.nearest, l), &lights, &scene);
    }
    for (int l = 0; l < PENCIL_WIDTH && first + l < path_count; ++l) {
        radiance[first + l] = paths[l].sum.x;
        radiance[path_count + first + l] = paths[l].sum.y;
        radiance[2 * (size_t)path_count + first + l] = paths[l].sum.z;
    }
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH paths
/// in     : surfels; starts[path_count]: the surfel of each path, -1: none; emitters[emitter_count], densities[material] and sky_density: as
///          in EmitterTable; orders: reflections at most, -1: no limit; seed; the scene
/// out    : radiance[3][path_count]: an estimate of what each surfel reflects to the eye [W m^-2 sr^-1]: the film knows
///          better what it emits
kernel void trace_checks(global const float *surfels, int capacity, global const int *starts, int path_count,
                         global const Emitter *emitters, int emitter_count, global const float *densities, float sky_density,
                         SKY_PARAMETERS, int orders, uint seed, HIERARCHY_PARAMETERS, SURFACES_PARAMETERS, global float *radiance) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= path_count) return;
    trace_checks_packet(first, surfels, capacity, starts, path_count, emitters, emitter_count, densities, sky_density, SKY_ARGUMENTS,
                        orders, seed, nodes, leaves, SURFACES_ARGUMENTS, radiance);
}
