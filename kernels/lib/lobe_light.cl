// What light samples send along the lobes of surfels: the share that rays along the lobes do not carry (follow_surfels.cl), by the balance
// heuristic (Veach 1997, 9.2).

#include "lib/bsdf.cl"
#include "lib/hemisphere.cl"
#include "lib/light_profile.cl"
#include "lib/packet.cl"
#include "lib/surfel.cl"
#include "lib/surfel_packet.cl"
#include "shared/light.h"

/// A light sample as a point of a surface receives it.
typedef struct Incident {
    float3 direction;  // towards the light, unit
    float form;        // what its emission is to be multiplied by for irradiance across the direction, if lobes had no share
    float density;     // of light samples per solid angle [1/sr], 0: rays do not find this light
} Incident;

static inline Incident incident_light(global const LightSample *sample, float3 x, float area_factor, global const half *tables) {
    float4 p = sample->position, n = sample->normal;
    Incident in;
    if (p.w == LIGHT_INFINITE) {
        in.direction = -p.xyz;
        in.form = 1.0f;
        in.density = n.w > 0.0f ? 1.0f / (n.w * area_factor) : 0.0f;
        return in;
    }
    float3 segment = p.xyz - x;
    float square = dot(segment, segment), inverse = rsqrt(square);
    in.direction = segment * inverse;
    in.form = 1.0f / square;
    in.density = 0.0f;
    if (p.w == LIGHT_AREA) {
        float cosine = fmax(-dot(n.xyz, in.direction), 0.0f);
        in.form *= cosine;
        in.density = square / fmax(cosine * M_PI_F * n.w * area_factor, 1e-30f);
    } else if (p.w == LIGHT_PROFILE) {
        in.form *= profile_share(tables, (int)sample->emission.w, n.xyz, -in.direction);
    } else if (p.w == LIGHT_SPOT) {
        float angle = acos(clamp(-dot(n.xyz, in.direction), -1.0f, 1.0f));
        in.form *= clamp((sample->emission.w - angle) / fmax(sample->emission.w - n.w, 1e-6f), 0.0f, 1.0f);
    }
    return in;
}

/// Radiance that the lobes of a surfel send back, and what its base sends back beyond even light, for light of this emission; rays: so many are drawn
/// along the lobes beside the samples.
static inline float3 lobe_radiance(const Vertex *v, float3 factor, const Incident *in, float3 emission, int rays) {
    float3 n = v->n, t, b;
    frame_towards(n, v->o, &t, &b);
    float3 omega_i = (float3)(dot(in->direction, t), dot(in->direction, b), dot(in->direction, n));
    if (!(omega_i.z * dot(in->direction, v->g) > 0.0f)) return (float3)(0.0f);
    float3 omega_o = seen_from(n, v->o);
    float share = 1.0f;
    if (in->density > 0.0f) share = in->density / (in->density + rays * bsdf_pdf(&v->bsdf, omega_o, omega_i));
    float3 lobes = factor * bsdf_evaluate(&v->bsdf, omega_o, omega_i) * share;
    if (omega_i.z < 0.0f) return emission * in->form * lobes;
    float3 base = v->albedo * (M_1_PI_F * omega_i.z * (bsdf_base_factor(&v->bsdf, omega_o, omega_i) - 1.0f));
    return emission * in->form * (lobes + base);
}

/// True of a surfel that light samples reach otherwise than by its irradiance.
static inline bool has_lobes(global const float *surfels, size_t capacity, int i, global const Material *materials) {
    int row = SURFEL_CONST_INT(surfels, SURFEL_MATERIAL * capacity + i);
    if (SURFEL_CONST_INT(surfels, SURFEL_PLANE * capacity + i) < 0 || row == PENCIL_NO_MATERIAL) return false;
    int model = materials[row < 0 ? ~row : row].model;
    return model != MATERIAL_DIFFUSE && model != MATERIAL_PASS;
}

/// True if rough lobes of a surfel let light through from behind.
static inline bool lobes_pass(global const float *surfels, size_t capacity, int i, global const Material *materials) {
    int row = SURFEL_CONST_INT(surfels, SURFEL_MATERIAL * capacity + i);
    global const Material *m = materials + (row < 0 ? ~row : row);
    if (m->model == MATERIAL_PRINCIPLED) return m->parameters[1] > 0.0f;
    return m->model == MATERIAL_DIELECTRIC && !(m->flags & MATERIAL_THIN) && surfels[SURFEL_ALPHA * capacity + i] >= SMOOTH_ALPHA;
}

/// -1 for lanes of `lanes` whose rough lobes let light through.
static inline vint lanes_that_pass(global const float *surfels, size_t capacity, int first, global const Material *materials, int lanes) {
    int passes = 0;
    for (int l = 0; l < PENCIL_WIDTH; ++l)
        if (lanes >> l & 1) passes |= lobes_pass(surfels, capacity, first + l, materials) << l;
    return PACKET_FROM_BITS(passes);
}

/// The surfels as light from (vx, vy, vz) meets them: those of `passes` that lie behind it turn to it.
static inline SurfelPacket turned_to(const SurfelPacket *s, vint passes, vfloat vx, vfloat vy, vfloat vz) {
    SurfelPacket t = *s;
    vint behind = passes & PACKET_MASK(fma(s->nx, vx, fma(s->ny, vy, s->nz * vz)) > 0.0f);
    t.nx = select(s->nx, -s->nx, behind);
    t.ny = select(s->ny, -s->ny, behind);
    t.nz = select(s->nz, -s->nz, behind);
    if (PENCIL_SMOOTH || PENCIL_RELIEF) {
        t.gx = select(s->gx, -s->gx, behind);
        t.gy = select(s->gy, -s->gy, behind);
        t.gz = select(s->gz, -s->gz, behind);
    }
    return t;
}

static inline int lanes_with_lobes(global const float *surfels, size_t capacity, int first, global const Material *materials) {
    int lanes = 0;
    for (int l = 0; l < PENCIL_WIDTH; ++l) lanes |= has_lobes(surfels, capacity, first + l, materials) << l;
    return lanes;
}

static inline float3 surfel_throughput(global const float *surfels, size_t capacity, int i) {
    return surfel_vector(surfels, capacity, i, SURFEL_TR);
}

/// Adds to rgb what `lanes` of the packet at `first` send back of a sample, of which a share reaches them; emission: its own, times 1 / the chance of the draw.
static inline void add_lobes(float rgb[3][PENCIL_WIDTH], int lanes, vfloat share, global const LightSample *sample,
                             global const float *surfels, size_t capacity, int first, global const Material *materials,
                             global const half *tables, float4 emission, float area_factor) {
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        float reaches = LANE_FLOAT(share, l);
        if (!(lanes >> l & 1 && reaches > 0.0f)) continue;
        Vertex v = load_vertex(surfels, capacity, first + l, materials, tables);
        Incident in = incident_light(sample, v.x, area_factor, tables);
        float3 radiance = lobe_radiance(&v, surfel_throughput(surfels, capacity, first + l), &in, reaches * emission.xyz, 1);
        rgb[0][l] += radiance.x;
        rgb[1][l] += radiance.y;
        rgb[2][l] += radiance.z;
    }
}
