// A chain of rays along the lobes of surfaces: one step of it.

#include "lib/bsdf.cl"
#include "lib/colour.cl"
#include "lib/film_chains.cl"
#include "lib/hash.cl"
#include "lib/hemisphere.cl"
#include "lib/packet.cl"
#include "lib/surfel.cl"

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
    float3 from;    // the last vertex that turned the chain
    bool negative;  // it says by how much less than in even light a base scatters
    float uneven;   // what it counts beside even light, of either sign, if that is known to be 0 in the mean; else 0
    float pdf;      // of the direction there; 0: of a lobe without width, -1: there is no such vertex
    bool on_film;   // it lies on the film
    uint bits;
    int number, shared;  // which one of so many of its surfel
    bool balanced;       // light samples on the surfel know how many chains there are
    uint3 shift;         // of the points of the surfel's chains, as fractions of 2^32
    bool open;
} Chain;

/// Point k of a sequence that fills the cube evenly: multiples of the powers of 1 / 1.22074, the root of x^4 = x + 1 (Roberts 2018).
static inline uint3 even_point(uint k) { return k * (uint3)(0xd1b54a33u, 0xabc98388u, 0x8cb92ba7u); }

static inline float chain_random(Chain *c) {
    c->bits = hash_uint(c->bits);
    return (c->bits >> UNIT_SHIFT) * UNIT_STEP;
}

static inline float3 chain_point(Chain *c) {
    float u = chain_random(c), v = chain_random(c), w = chain_random(c);
    return (float3)(u, v, w);
}

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

/// Chance at most that a chain goes on from what emits: its emission is most of what it sends.
#define CHAIN_LEAVES_LAMP 0.25f
/// The density of a direction in place of which light samples have taken all they can.
#define CHAIN_TAKEN 1e-20f

/// A direction for what the base of a surfel of the film scatters beside the even share that its irradiance says (project_film_pencils.cl).
/// Light samples do the same for themselves (lobe_light.cl).
static inline BsdfSample sample_uneven(Chain *c, float3 omega_o, float2 u) {
    float radius = sqrt(u.x), phi = 2.0f * M_PI_F * u.y;
    BsdfSample s = {(float3)(radius * cos(phi), radius * sin(phi), sqrt(1.0f - u.x)), (float3)(0.0f), CHAIN_TAKEN};
    float uneven = bsdf_base_factor(&c->at.bsdf, omega_o, s.omega_i) - 1.0f;
    c->negative = uneven < 0.0f;
    c->uneven = c->at.bsdf.model == MATERIAL_PLASTIC ? uneven : 0.0f;  // the others divide by means that are up to a percent off
    s.weight = c->at.albedo * fabs(uneven);
    return s;
}

/// The first direction of a chain of the film. Counts are fixed, not drawn: in even light chains say nothing new, to the last digit.
static inline BsdfSample first_direction(Chain *c, float3 omega_o, float lobes) {
    int for_base = chains_for_base(&c->at, lobes, c->shared);
    bool base = c->number < for_base;
    uint3 point = even_point((uint)(base ? c->number : c->number - for_base)) + c->shift;
    float3 u = convert_float3(point >> UNIT_SHIFT) * UNIT_STEP;
    BsdfSample s;
    if (base)
        s = sample_uneven(c, omega_o, u.xy);
    else {
        s = bsdf_sample(&c->at.bsdf, omega_o, u);
        if (c->balanced) s.pdf *= c->shared - for_base;
    }
    float weight = c->shared / (float)(base ? for_base : c->shared - for_base);
    c->uneven *= weight;
    s.weight *= weight;
    return s;
}

/// Decides whether the chain goes on from its vertex, and where to.
static inline void step_chain(Chain *c, bool always, int steps, global const Material *materials) {
    float3 t, b, n = c->at.n, omega_o = seen_from(n, c->at.o);
    if (c->at.plane < 0 || c->at.bsdf.model == MATERIAL_DIFFUSE) {
        c->open = false;
        return;
    }
    float lobes = largest(bsdf_share(&c->at.bsdf, omega_o) * c->t.factor), base = largest(c->at.albedo);
    int row = c->at.row >= 0 ? c->at.row : ~c->at.row;
    float stays = lobes_are_smooth(&c->at.bsdf) ? base : base + CHAIN_STAYS * lobes;
    float chance = always ? 1.0f : lobes > 0.0f ? lobes / (lobes + stays) : 0.0f;
    if (!always && any(materials[row].emission.xyz > 0.0f)) chance = fmin(chance, CHAIN_LEAVES_LAMP);
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
        s = bsdf_sample(&c->at.bsdf, omega_o, chain_point(c));
    frame_towards(n, c->at.o, &t, &b);
    c->direction = normalize(s.omega_i.x * t + s.omega_i.y * b + s.omega_i.z * n);
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
