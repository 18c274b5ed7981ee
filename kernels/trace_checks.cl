// Light paths from surface points, estimates of reflected light that owe nothing to the methods that they check: no cache, no reuse, every
// vertex lit by one sample of the emitters and by what its own ray meets, combined by the balance heuristic (Veach 1997, 9.2), ended by
// Russian roulette without a bound below 1.

#include "lib/brdf.cl"
#include "lib/hash.cl"
#include "lib/hemisphere.cl"
#include "lib/packet.cl"
#include "lib/rays.cl"
#include "lib/surfel.cl"
#include "shared/emitter.h"
#include "shared/surfel.h"

/// Reflections after which a path may end.
#define CHECK_SURE_ORDERS 3
/// Where nothing is lost paths would never end. At an albedo of 0.995 less than a hundredth of the light is beyond.
#define CHECK_MOST_ORDERS 1024
/// Segments to emitters end this share before them.
#define CHECK_SHADOW_END 0.9999f

/// One path: where it is, what it carries.
typedef struct CheckPath {
    float3 position, normal, facing;  // shading and geometric normal of the side that was met
    float3 throughput;                // with the albedo of this vertex; 0: it has ended
    float3 sum;
    int plane;
    uint bits;
    float cosine;  // of the ray to here at its origin: its density times pi
} CheckPath;

/// As luminance of image/colour.h: emitters are chosen by it.
static inline float emitter_luminance(float3 radiance) { return dot(radiance, (float3)(0.2126f, 0.7152f, 0.0722f)); }

static inline float check_random(CheckPath *p) {
    p->bits = hash_uint(p->bits);
    return (p->bits >> UNIT_SHIFT) * UNIT_STEP;
}

/// At the surfel that a path starts on, with what that emits.
static inline CheckPath begin_path(global const float *surfels, size_t capacity, int surfel, uint bits) {
    CheckPath p = {(float3)(0.0f), (float3)(0.0f), (float3)(0.0f), (float3)(0.0f), (float3)(0.0f), -1, bits, 0.0f};
    if (surfel < 0) return p;
    global const float *s = surfels + surfel;
    p.plane = as_int(s[SURFEL_PLANE * capacity]);
    if (p.plane < 0) return p;
    p.position = (float3)(s[SURFEL_X * capacity], s[SURFEL_Y * capacity], s[SURFEL_Z * capacity]);
    p.normal = (float3)(s[SURFEL_NX * capacity], s[SURFEL_NY * capacity], s[SURFEL_NZ * capacity]);
    p.facing = (float3)(s[SURFEL_GX * capacity], s[SURFEL_GY * capacity], s[SURFEL_GZ * capacity]);
    p.throughput = (float3)(s[SURFEL_ALBEDO_R * capacity], s[SURFEL_ALBEDO_G * capacity], s[SURFEL_ALBEDO_B * capacity]);
    return p;
}

/// The emitter at share u of all power.
static inline int find_emitter(global const Emitter *emitters, int count, float u) {
    int low = 0, high = count - 1;
    while (low < high) {
        int middle = (low + high) / 2;
        if (emitters[middle].emission.w > u)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

/// A segment to a point of an emitter, and the radiance that the vertex reflects if nothing stands between; 0 if it sends none.
static inline float3 aim_check(CheckPath *p, global const Emitter *emitters, int emitter_count, float power,
                               global const Triangle *triangles, global const float4 *planes, global const Material *materials,
                               float3 *segment) {
    float u = check_random(p), v = check_random(p), w = check_random(p);
    *segment = (float3)(0.0f);
    global const Emitter *e = emitters + find_emitter(emitters, emitter_count, u);
    if (e->triangle < 0) {
        *segment = e->position.xyz - p->position;
        float square = dot(*segment, *segment), cosine = dot(p->normal, *segment) * rsqrt(square);
        if (!(cosine > 0.0f) || !(dot(p->facing, *segment) > 0.0f)) return (float3)(0.0f);
        return p->throughput * e->emission.xyz * (cosine * M_1_PI_F / (square * e->chance));
    }
    global const Triangle *t = triangles + e->triangle;
    float root = sqrt(v);
    float3 at = ((1.0f - root) * t->v0 + root * (1.0f - w) * t->v1 + root * w * t->v2).xyz;
    *segment = at - p->position;
    float square = dot(*segment, *segment), inverse = rsqrt(square);
    float cosine = dot(p->normal, *segment) * inverse, light_cosine = -dot(planes[t->plane].xyz, *segment) * inverse;
    if (!(cosine > 0.0f) || !(light_cosine > 0.0f) || !(dot(p->facing, *segment) > 0.0f)) return (float3)(0.0f);
    float4 emission = materials[t->material].emission;
    // Densities per area, that of the ray's own direction cos cos_l / (pi r^2): the balance heuristic divides by their sum.
    float density = emitter_luminance(emission.xyz) / power;
    float form = cosine * light_cosine * M_1_PI_F;
    return p->throughput * emission.xyz * (form / (density * square + form));
}

/// A cosine-distributed direction about the normal.
static inline float3 next_direction(CheckPath *p) {
    float u = check_random(p), v = check_random(p);
    float3 t, b;
    tangent_frame(p->normal, &t, &b);
    float radius = sqrt(u), phi = 2.0f * M_PI_F * v;
    p->cosine = sqrt(1.0f - u);
    return radius * cos(phi) * t + radius * sin(phi) * b + p->cosine * p->normal;
}

/// The path goes on at what its ray has met: takes its emission, and its albedo into the throughput.
static inline void arrive(CheckPath *p, float3 direction, int triangle, float distance, float power, global const Triangle *triangles,
                          global const float4 *planes, global const Material *materials, global const float4 *normals) {
    if (triangle < 0) {
        p->throughput = (float3)(0.0f);
        return;
    }
    global const Triangle *t = triangles + triangle;
    global const Material *m = materials + t->material;
    float4 plane = planes[t->plane];
    bool front = dot(plane.xyz, direction) < 0.0f;
    float3 emission = m->emission.xyz;
    if (front && any(emission > 0.0f)) {
        float density = emitter_luminance(emission) / power;
        float form = p->cosine * -dot(plane.xyz, direction) * M_1_PI_F;
        p->sum += p->throughput * emission * (form / (density * distance * distance + form));
    }
    float4 origin = (float4)(p->position, 0.0f);
    p->facing = front ? plane.xyz : -plane.xyz;
    p->normal = p->facing;
    if (PENCIL_SMOOTH) {
        float3 w = hit_barycentric(t, origin, (float4)(direction, 0.0f));
        global const float4 *corner = normals + 3 * triangle;
        float3 n = w.x * corner[0].xyz + w.y * corner[1].xyz + w.z * corner[2].xyz;
        if (dot(n, n) > 0.0f) p->normal = normalize(front ? n : -n);
    }
    p->position += distance * direction;
    p->plane = t->plane;
    float3 towards = (float3)(0.0f, 0.0f, clamp(-dot(p->normal, direction), 0.0f, 1.0f));
    bool reflects = front || m->albedo.w != 0.0f;
    p->throughput *= reflects ? brdf_albedo(m, towards) : (float3)(0.0f);
}

/// Rays from the vertices along `directions` up to `end`; none where that is below 0.
static inline LaneRays rays_of_paths(const CheckPath *paths, const float3 *directions, const float *end) {
    float o[3][PENCIL_WIDTH], d[3][PENCIL_WIDTH];
    int own[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        o[0][l] = paths[l].position.x;
        o[1][l] = paths[l].position.y;
        o[2][l] = paths[l].position.z;
        d[0][l] = directions[l].x;
        d[1][l] = directions[l].y;
        d[2][l] = directions[l].z;
        own[l] = paths[l].plane;
    }
    return lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), PACKET_LOAD(d[0]), PACKET_LOAD(d[1]), PACKET_LOAD(d[2]),
                     PACKET_LOAD(own), PACKET_LOAD(end));
}

/// Light from one sample of the emitters to each path's vertex.
static inline void light_vertices(CheckPath *paths, global const Emitter *emitters, int emitter_count, float power,
                                  global const BvhNode *nodes, global const int *leaves, global const Triangle *triangles,
                                  global const float4 *planes, global const Material *materials) {
    float3 light[PENCIL_WIDTH], segments[PENCIL_WIDTH];
    float end[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        segments[l] = light[l] = (float3)(0.0f);
        if (any(paths[l].throughput > 0.0f))
            light[l] = aim_check(paths + l, emitters, emitter_count, power, triangles, planes, materials, segments + l);
        end[l] = any(light[l] > 0.0f) ? CHECK_SHADOW_END : -1.0f;
    }
    LaneRays rays = rays_of_paths(paths, segments, end);
    lanes_trace(&rays, true, nodes, leaves, triangles, planes);
    for (int l = 0; l < PENCIL_WIDTH; ++l)
        if (end[l] > 0.0f && LANE_INT(rays.triangle, l) < 0) paths[l].sum += light[l];
}

/// Ends the path by Russian roulette, or gives it a direction. False if it has ended.
static inline bool go_on(CheckPath *p, int order, float3 *direction) {
    *direction = (float3)(0.0f);
    if (order > CHECK_SURE_ORDERS) {
        float survival = fmin(fmax(p->throughput.x, fmax(p->throughput.y, p->throughput.z)), 1.0f);
        p->throughput = survival > 0.0f && check_random(p) < survival ? p->throughput / survival : (float3)(0.0f);
    }
    if (any(p->throughput > 0.0f)) *direction = next_direction(p);
    if (dot(*direction, p->facing) > 0.0f) return true;
    p->throughput = (float3)(0.0f);
    return false;
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH paths
/// in     : surfels; starts[path_count]: the surfel of each path, -1: none; emitters[emitter_count] and their power, luminance of radiance times
///          area summed, a point light as a small sphere [scene units^2]; orders: reflections at most, -1: no limit; seed; the scene
/// out    : radiance[3][path_count]: an estimate of what each surfel reflects to the eye [W m^-2 sr^-1]: the film knows
///          better what it emits
kernel void trace_checks(global const float *surfels, int capacity, global const int *starts, int path_count,
                         global const Emitter *emitters, int emitter_count, float power, int orders, uint seed, global const BvhNode *nodes,
                         global const int *leaves, global const Triangle *triangles, global const float4 *planes,
                         global const Material *materials, global const float4 *normals, global float *radiance) {
    int first = get_global_id(0) * PENCIL_WIDTH;
    if (first >= path_count) return;
    CheckPath paths[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l)
        paths[l] = begin_path(surfels, capacity, first + l < path_count ? starts[first + l] : -1, hash_uint(seed + hash_uint(first + l)));
    int most = orders < 0 ? CHECK_MOST_ORDERS : orders;
    for (int order = 1; order <= most; ++order) {
        if (emitter_count > 0) light_vertices(paths, emitters, emitter_count, power, nodes, leaves, triangles, planes, materials);
        float3 directions[PENCIL_WIDTH];
        float end[PENCIL_WIDTH];
        bool alive = false;
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            bool goes_on = go_on(paths + l, order, directions + l);
            end[l] = goes_on ? INFINITY : -1.0f;
            alive |= goes_on;
        }
        if (!alive) break;
        LaneRays rays = rays_of_paths(paths, directions, end);
        lanes_trace(&rays, false, nodes, leaves, triangles, planes);
        for (int l = 0; l < PENCIL_WIDTH; ++l)
            if (end[l] > 0.0f)
                arrive(paths + l, directions[l], LANE_INT(rays.triangle, l), LANE_FLOAT(rays.nearest, l), power, triangles, planes,
                       materials, normals);
    }
    for (int l = 0; l < PENCIL_WIDTH && first + l < path_count; ++l) {
        radiance[first + l] = paths[l].sum.x;
        radiance[path_count + first + l] = paths[l].sum.y;
        radiance[2 * (size_t)path_count + first + l] = paths[l].sum.z;
    }
}
