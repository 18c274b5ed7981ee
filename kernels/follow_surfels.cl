// Follows light back along the lobes of surfaces (mirrors, glass, gloss): a surfel with lobes is replaced by what a chain of scattered rays ends
// on. At each surface the chain stops, which stands for the base of the surface and for light samples on its lobes, or goes on along its lobes,
// by chance; both count by what is in their place, so that the mean over all chains is exact.

#include "lib/bsdf.cl"
#include "lib/hash.cl"
#include "lib/hemisphere.cl"
#include "lib/packet.cl"
#include "lib/rays.cl"
#include "lib/surfel.cl"
#include "shared/surfel.h"

/// Chains this long end by Russian roulette.
#define CHAIN_SURE 4
/// Chains end here; what is lost beyond is below the survival of the roulette to this power.
#define CHAIN_MOST 64

/// How much light samples on rough lobes count beside what their rays find, when a chain chooses: the less, the less weights grow along it.
#define CHAIN_STAYS 0.3f

typedef struct Chain {
    Vertex at;
    Throughput t;
    float3 direction;
    float3 from;   // the last vertex that turned the chain
    float sign;    // of what it carries
    float pdf;     // of the direction there; 0: of a lobe without width, -1: there is no such vertex
    bool on_film;  // it lies on the film
    uint bits;
    uint3 first;  // where the first direction lies among those of the surfel's chains, as fractions of 2^32
    bool open;
} Chain;

/// Point k of a sequence that fills the cube evenly: multiples of the powers of 1 / 1.22074, the root of x^4 = x + 1 (Roberts 2018).
static inline uint3 even_point(uint k) { return k * (uint3)(0xd1b54a33u, 0xabc98388u, 0x8cb92ba7u); }

static inline float chain_random(Chain *c) {
    c->bits = hash_uint(c->bits);
    return (c->bits >> UNIT_SHIFT) * UNIT_STEP;
}

static inline float largest(float3 v) { return fmax(v.x, fmax(v.y, v.z)); }

/// Light samples do not reach lobes without width, nor light that passes through.
static inline bool lobes_are_smooth(const Bsdf *b) {
    return b->model == MATERIAL_PASS || (b->alpha < SMOOTH_ALPHA && b->model != MATERIAL_PHONG) ||
           (b->flags & MATERIAL_THIN && b->model == MATERIAL_DIELECTRIC);
}

/// Puts an end to a chain that carries nothing.
static inline void end_chain(Chain *c) {
    c->open = false;
    c->at = meet_nothing(c->direction);
    c->t.factor = (float3)(0.0f);
}

/// Weight of light that a base scatters otherwise than evenly, beside lobes, when a chain of the film chooses.
#define CHAIN_UNEVEN 0.25f
/// The density of a direction in place of which light samples have taken all they can.
#define CHAIN_TAKEN 1e-20f

/// True of models whose bases look at where light comes from.
static inline bool base_is_uneven(int model) {
    return model == MATERIAL_PLASTIC || model == MATERIAL_PRINCIPLED || model == MATERIAL_ROUGH_DIFFUSE;
}

/// A direction for what the base of a surfel of the film scatters beside the even share that its irradiance says (project_film_pencils.cl): of
/// either sign. Light samples do the same for themselves (lobe_light.cl).
static inline BsdfSample sample_uneven(Chain *c, float3 omega_o, float2 u) {
    float radius = sqrt(u.x), phi = 2.0f * M_PI_F * u.y;
    BsdfSample s = {(float3)(radius * cos(phi), radius * sin(phi), sqrt(1.0f - u.x)), (float3)(0.0f), CHAIN_TAKEN};
    float beyond = bsdf_base_factor(&c->at.bsdf, omega_o, s.omega_i) - 1.0f;
    c->sign = beyond < 0.0f ? -1.0f : 1.0f;
    s.weight = c->at.albedo * fabs(beyond);
    return s;
}

/// The first direction of a chain of the film.
static inline BsdfSample first_direction(Chain *c, float3 omega_o, float lobes) {
    float3 u = convert_float3(c->first >> UNIT_SHIFT) * UNIT_STEP;
    float uneven = base_is_uneven(c->at.bsdf.model) ? CHAIN_UNEVEN * largest(c->at.albedo) : 0.0f;
    float chance = uneven > 0.0f ? uneven / (uneven + lobes) : 0.0f;
    bool base = u.z < chance;
    BsdfSample s;
    if (base) {
        s = sample_uneven(c, omega_o, u.xy);
    } else {
        u.z = (u.z - chance) / (1.0f - chance);
        s = bsdf_sample(&c->at.bsdf, omega_o, u);
    }
    s.weight /= base ? chance : 1.0f - chance;
    return s;
}

/// Decides whether the chain goes on from its vertex, and where to.
static inline void step_chain(Chain *c, bool always, int steps, global const Material *materials) {
    float3 frame_t, frame_b, n = c->at.n, o = c->at.o;
    float3 omega_o = seen_from(n, o), across = o - dot(n, o) * n;
    float width = length(across);
    if (c->at.plane < 0 || c->at.bsdf.model == MATERIAL_DIFFUSE) {
        c->open = false;
        return;
    }
    float lobes = largest(bsdf_share(&c->at.bsdf, omega_o) * c->t.factor), base = largest(c->at.albedo);
    int row = c->at.row >= 0 ? c->at.row : ~c->at.row;
    float stays = lobes_are_smooth(&c->at.bsdf) ? base : base + CHAIN_STAYS * lobes;
    if (any(materials[row].emission.xyz > 0.0f)) lobes = 0.0f;  // what emits stays, with light samples on its lobes
    float chance = always ? 1.0f : lobes > 0.0f ? lobes / (lobes + stays) : 0.0f;
    if (chain_random(c) >= chance) {
        float weight = 1.0f / fmax(1.0f - chance, 1e-6f);
        c->at.albedo *= weight;
        if (chance > 0.0f) c->t.factor *= weight;
        c->open = false;
        return;
    }
    float survives = steps >= CHAIN_SURE ? clamp(largest(c->t.factor), 0.0f, 1.0f) : 1.0f;
    if (steps >= CHAIN_MOST || !(chain_random(c) < survives)) {
        end_chain(c);
        return;
    }
    BsdfSample s;
    if (always)
        s = first_direction(c, omega_o, lobes);
    else
        s = bsdf_sample(&c->at.bsdf, omega_o, (float3)(chain_random(c), chain_random(c), chain_random(c)));
    frame_t = width > 1e-6f ? across / width : (float3)(0.0f);
    if (width > 1e-6f)
        frame_b = cross(n, frame_t);
    else
        tangent_frame(n, &frame_t, &frame_b);
    c->direction = normalize(s.omega_i.x * frame_t + s.omega_i.y * frame_b + s.omega_i.z * n);
    c->t.factor *= s.weight / (chance * survives);
    if (!(PENCIL_CLEAR && goes_straight(&c->at.bsdf, &s))) {
        c->from = c->at.x;
        c->pdf = s.pdf;
        c->on_film = always;
    }
    bool inside = dot(c->direction, c->at.g) * s.omega_i.z > 0.0f;  // shading and geometric normal agree on the side
    if (!inside || !(largest(c->t.factor) > 0.0f)) end_chain(c);
}

/// The chain arrives at what its ray has met. near_area, sky_samples: of the light samples that reach the last vertex that turned it.
static inline void arrive_chain(Chain *c, int triangle, float distance, const Surfaces *scene, global const float *near_area,
                                float sky_samples) {
    if (triangle < 0) {
        c->at = meet_nothing(c->direction);
        c->t.share = c->pdf <= 0.0f ? c->pdf : sky_samples > 0.0f ? c->pdf / sky_samples : 0.0f;  // as sky_radiance has it
        c->open = false;
        return;
    }
    Hit hit = {triangle, 1.0f / distance};
    float4 from = (float4)(c->at.x, 0.0f);
    Vertex at = meet_surface(scene, hit, from, (float4)(c->direction, 0.0f), hash_uint(c->bits ^ 0x68bc21ebu));
    int row = scene->triangles[triangle].material;
    c->t.share = c->pdf < 0.0f ? -1.0f : 1.0f;
    if (c->pdf > 0.0f && near_area[row] < INFINITY) {
        // Densities per area of light samples, 1 / (pi near_area), and of the scattered ray.
        float form = c->pdf * fabs(dot(at.g, c->direction)) * M_PI_F * near_area[row];
        float3 segment = at.x - c->from;
        c->t.share = form / (form + dot(segment, segment));
    }
    at.albedo *= c->t.factor;
    c->at = at;
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH chains
/// in     : from[from_capacity]: surfels that chains start on; starts[chain_count]: which of them, where there is a list, else chain k starts on
///          surfel first + k; shared: so many chains one after the other start on the same, and all take a first step along the lobes, 0: each has a
///          surfel of its own and may stop there; near_first, near_next
///          [material]: of the light samples that reach the first vertex and the others (emit_hemispheres.cl); sky_first, sky_next: number of those
///          that are the sky's; the scene; seed
/// out    : surfels[capacity], from number `first` on: where chains end, with what they carry. May be the same buffer as `from`.
kernel void follow_surfels(global const float *from, int from_capacity, global const int *starts, int listed, int shared, int chain_count,
                           global const float *near_first, global const float *near_next, float sky_first, float sky_next, uint seed,
                           global const BvhNode *nodes, global const int *leaves, SURFACES_PARAMETERS, global float *surfels, int capacity,
                           int first) {
    int begin = get_global_id(0) * PENCIL_WIDTH;
    if (begin >= chain_count) return;
    Surfaces scene = SURFACES;
    Chain chains[PENCIL_WIDTH];
    bool any_open = false;
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        Chain *c = chains + l;
        c->open = begin + l < chain_count;
        c->pdf = shared ? 0.0f : -1.0f;  // what the film sees through clear things it sees; hemispheres have light samples for it
        c->on_film = false;
        c->sign = 1.0f;
        c->bits = hash_uint(seed + hash_uint((uint)(begin + l)));
        if (!c->open) continue;
        if (shared) {
            uint of_surfel = hash_uint(seed ^ hash_uint((uint)((begin + l) / shared)));
            uint3 from_surfel = (uint3)(of_surfel, hash_uint(of_surfel), hash_uint(of_surfel ^ 0x5bd1e995u));
            c->first = even_point((uint)((begin + l) % shared)) + from_surfel;
        }
        int start = listed ? starts[begin + l] : first + begin + l;
        c->at = load_vertex(from, from_capacity, start, materials, bitmaps);
        c->t.factor = (float3)(1.0f);
        c->t.share = -1.0f;
        c->direction = -c->at.o;
        c->open = c->at.plane >= 0 && c->at.bsdf.model != MATERIAL_DIFFUSE;
        any_open |= c->open;
    }
    if (!any_open && !listed) return;
    for (int steps = 0; any_open; ++steps) {
        float o[3][PENCIL_WIDTH], d[3][PENCIL_WIDTH], end[PENCIL_WIDTH];
        int own[PENCIL_WIDTH];
        any_open = false;
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            Chain *c = chains + l;
            if (c->open) step_chain(c, shared && steps == 0, steps, materials);
            end[l] = c->open ? INFINITY : -1.0f;
            own[l] = c->open ? c->at.plane : -1;
            for (int k = 0; k < 3; ++k) o[k][l] = d[k][l] = 0.0f;
            if (!c->open) continue;
            any_open = true;
            o[0][l] = c->at.x.x;
            o[1][l] = c->at.x.y;
            o[2][l] = c->at.x.z;
            d[0][l] = c->direction.x;
            d[1][l] = c->direction.y;
            d[2][l] = c->direction.z;
        }
        if (!any_open) break;
        LaneRays rays = lane_rays(PACKET_LOAD(o[0]), PACKET_LOAD(o[1]), PACKET_LOAD(o[2]), PACKET_LOAD(d[0]), PACKET_LOAD(d[1]),
                                  PACKET_LOAD(d[2]), PACKET_LOAD(own), PACKET_LOAD(end));
        lanes_trace(&rays, false, nodes, leaves, triangles, planes);
#pragma unroll 1
        for (int l = 0; l < PENCIL_WIDTH; ++l)
            if (chains[l].open)
                arrive_chain(chains + l, LANE_INT(rays.triangle, l), LANE_FLOAT(rays.nearest, l), &scene,
                             chains[l].on_film ? near_first : near_next, chains[l].on_film ? sky_first : sky_next);
    }
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH && begin + l < chain_count; ++l) {
        // The albedo of a vertex already holds what the chain carries.
        Vertex v = chains[l].at;
        float3 f = chains[l].t.factor;
        v.albedo =
            (float3)(f.x > 0.0f ? v.albedo.x / f.x : 0.0f, f.y > 0.0f ? v.albedo.y / f.y : 0.0f, f.z > 0.0f ? v.albedo.z / f.z : 0.0f);
        chains[l].t.factor *= chains[l].sign;
        store_vertex(surfels, capacity, first + begin + l, &v, chains[l].t);
    }
}
