// What the own rays of surfels bring, where pencils are blind: light of things so near that no pencil lies between. A ray goes by the
// cosine, and what it meets is looked up in the map of a pencil that sees the same place: a pencil set is a field of light as well as a set
// of lines. Balanced with the lines by project_pencils (lib/balance.cl).

#include "lib/balance.cl"
#include "lib/footprint.cl"
#include "lib/hash.cl"
#include "lib/hemisphere.cl"
#include "lib/map.cl"
#include "lib/packet.cl"
#include "lib/projection.cl"
#include "lib/rays.cl"
#include "lib/surfel_packet.cl"
#include "lib/visibility.cl"
#include "shared/atlas.h"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/weights.h"

#if PENCIL_WEIGHTS == PENCIL_WEIGHTS_POWER

/// Pencils that are asked, the best first, before a ray is given up.
#define MOST_ASKED 16
/// Bilinear weight of the texels that show a place, from which on a pencil shows it.
#define LEAST_WEIGHT 0.02f
/// A texel shows a place if what it shows lies so near, in terms of its own width.
#define NEAR_TEXELS 2.0f

/// A pencil set as a field of light.
typedef struct PencilField {
    VisibilityMap map;
    global const float4 *cops, *radiance;
    int count;
} PencilField;

/// Box in which centres lie, and the volume of the part of it where they may.
typedef struct CentreSpace {
    float4 low, high;
    float volume;
} CentreSpace;

/// Places that rays have met.
typedef struct Places {
    vfloat x, y, z;
    vfloat nx, ny, nz;  // normals on the side that was met
    vint plane;
    vint open;  // lanes that look for light
} Places;

static inline Places places_met(const LaneRays *r, global const Triangle *triangles, global const float4 *planes) {
    Places p;
    p.open = PACKET_MASK(r->triangle >= 0);
    vfloat t = select((vfloat)(0.0f), r->nearest, p.open);
    p.x = fma(t, r->x, r->ox);
    p.y = fma(t, r->y, r->oy);
    p.z = fma(t, r->z, r->oz);
    float nx[PENCIL_WIDTH], ny[PENCIL_WIDTH], nz[PENCIL_WIDTH];
    int own[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        int triangle = LANE_INT(r->triangle, l);
        own[l] = triangle < 0 ? -1 : triangles[triangle].plane;
        float4 plane = own[l] < 0 ? (float4)(0.0f) : planes[own[l]];
        nx[l] = plane.x;
        ny[l] = plane.y;
        nz[l] = plane.z;
    }
    p.nx = PACKET_LOAD(nx);
    p.ny = PACKET_LOAD(ny);
    p.nz = PACKET_LOAD(nz);
    p.plane = PACKET_LOAD(own);
    vfloat side = copysign((vfloat)(1.0f), -fma(p.nx, r->x, fma(p.ny, r->y, p.nz * r->z)));
    p.nx *= side;
    p.ny *= side;
    p.nz *= side;
    return p;
}

/// Of each place the pencil whose texels are the finest there among those that are coarser than `limit`, which it replaces; -1: none.
/// Texels cover an area in proportion to r^2 / cos.
static inline vint next_pencil(const Places *p, const PencilField *field, vfloat *limit) {
    vfloat best = 0.0f;
    vint index = -1;
    for (int i = 0; i < field->count; ++i) {
        float4 cop = field->cops[i];
        vfloat vx = cop.x - p->x, vy = cop.y - p->y, vz = cop.z - p->z;
        vfloat s = packet_rsqrt(fma(vx, vx, fma(vy, vy, vz * vz)));
        vfloat fineness = fma(p->nx, vx, fma(p->ny, vy, p->nz * vz)) * (s * s * s);
        vint better = PACKET_MASK(fineness > best) & PACKET_MASK(fineness < *limit);
        best = select(best, fineness, better);
        index = select(index, (vint)(i), better);
    }
    *limit = best;
    return index;
}

/// Whether a texel of `pencil` that looks along `ray` shows the neighbourhood of place x, on the same side; own: its plane.
static inline bool texel_shows_place(const VisibilityMap *map, Hit hit, float4 cop, float4 ray, float4 x, int own, float3 normal) {
    if (hit.triangle < 0) return false;
    int plane = map->triangles[hit.triangle].plane;
    if (plane == own) return true;
    float4 seen = ray / hit.disparity, shown = map->planes[plane];
    if (plane_ahead(shown, cop) > 0.0f) shown = -shown;
    return distance(cop + seen, x) * (MAP_FINENESS * map->n) < NEAR_TEXELS * length(seen) && dot(shown.xyz, normal) > M_SQRT1_2_F;
}

/// Radiance (rgb) that place l sends to the centre of `pencil`, which passes it on in the same direction: the bilinear mean of those texels of
/// footprint lane l that show it; w: their weight, 0 where the pencil does not see the place.
static inline float4 texels_of_place(const Places *p, const PencilField *field, int pencil, const Footprint *f, int l) {
    const VisibilityMap *map = &field->map;
    const int n = map->n, own = LANE_INT(p->plane, l);
    int2 corner = footprint_corner(f, l), cell = map->cells[LANE_INT(f->index, l) + pencil * MAP_STORED(n)];
    float fx = LANE_FLOAT(f->fx, l), fy = LANE_FLOAT(f->fy, l);
    float4 cop = (float4)(field->cops[pencil].xyz, 0.0f), x = (float4)(LANE_FLOAT(p->x, l), LANE_FLOAT(p->y, l), LANE_FLOAT(p->z, l), 0.0f);
    float3 normal = (float3)(LANE_FLOAT(p->nx, l), LANE_FLOAT(p->ny, l), LANE_FLOAT(p->nz, l));
    float4 sum = (float4)(0.0f);
    if ((cell.x != own || cell.y != own) && !crowded_footprint_visible(map, pencil, corner, fx, fy, cop, x, own)) return sum;
    for (int k = 0; k < 4; ++k) {
        int2 texel = map_footprint_texel(corner, k, n);
        Hit hit = map->hits[map_atlas_index(pencil, texel, n)];
        if (!texel_shows_place(map, hit, cop, map_texel_direction(texel, n), x, own, normal)) continue;
        float weight = (k & 1 ? fx : 1.0f - fx) * (k >> 1 ? fy : 1.0f - fy);
        sum += weight * (float4)(field->radiance[map_atlas_index(pencil, map_antipode(texel, n), n)].xyz, 1.0f);
    }
    return sum;
}

/// Radiance of the places towards the best pencils that show them; w: 0 where none does.
static inline void look_up(Places p, const PencilField *field, float4 *light) {
    vfloat limit = INFINITY;
    for (int l = 0; l < PENCIL_WIDTH; ++l) light[l] = (float4)(0.0f);
    for (int k = 0; k < MOST_ASKED && PACKET_ANY(p.open); ++k) {
        vint asked = next_pencil(&p, field, &limit);
        p.open &= PACKET_MASK(asked >= 0);
        float x[PENCIL_WIDTH], y[PENCIL_WIDTH], z[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            float4 cop = field->cops[max(LANE_INT(asked, l), 0)];
            x[l] = cop.x;
            y[l] = cop.y;
            z[l] = cop.z;
        }
        Footprint f = map_footprint(p.x - PACKET_LOAD(x), p.y - PACKET_LOAD(y), p.z - PACKET_LOAD(z), field->map.n);
        int found[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) {
            found[l] = 0;
            if (!LANE_INT(p.open, l)) continue;
            float4 sum = texels_of_place(&p, field, LANE_INT(asked, l), &f, l);
            if (sum.w < LEAST_WEIGHT) continue;
            light[l] = sum / sum.w;
            found[l] = -1;
        }
        p.open &= ~PACKET_LOAD(found);
    }
}

/// Distance along the rays to where they leave the box of centres.
static inline vfloat box_exit(const LaneRays *r, const CentreSpace *space) {
    vfloat x = fmax((space->low.x - r->ox) * r->ix, (space->high.x - r->ox) * r->ix);
    vfloat y = fmax((space->low.y - r->oy) * r->iy, (space->high.y - r->oy) * r->iy);
    vfloat z = fmax((space->low.z - r->oz) * r->iz, (space->high.z - r->oz) * r->iz);
    return fmax(fmin(x, fmin(y, z)), (vfloat)(0.0f));
}

/// Rays of the surfels through stratum (column, row) of side^2, random in it by `key`; (x, y): along the tangents. Lanes below the geometric
/// horizon are not sent: nearest < 0.
static inline LaneRays surfel_rays(const SurfelPacket *s, vuint key, int column, int row, int side, vfloat *x, vfloat *y) {
    vuint u = hash_packet(key + (uint)(row * side + column)), v = hash_packet(u);
    concentric_disc(((vfloat)(column) + PACKET_UNIT(u)) * (2.0f / side) - 1.0f, ((vfloat)(row) + PACKET_UNIT(v)) * (2.0f / side) - 1.0f, x,
                    y);
    vfloat z = sqrt(fmax(1.0f - *x * *x - *y * *y, (vfloat)(1e-6f)));
    vfloat sign = copysign((vfloat)(1.0f), s->nz), k = -1.0f / (sign + s->nz), m = s->nx * s->ny * k;
    vfloat dx = fma(*x, fma(sign * s->nx * s->nx, k, (vfloat)(1.0f)), fma(*y, m, z * s->nx));
    vfloat dy = fma(*x, sign * m, fma(*y, fma(s->ny * s->ny, k, sign), z * s->ny));
    vfloat dz = fma(*x, -sign * s->nx, fma(*y, -s->ny, z * s->nz));
    vint above = PACKET_MASK(s->plane >= 0);
    if (PENCIL_SMOOTH || PENCIL_RELIEF) above &= PACKET_MASK(fma(s->gx, dx, fma(s->gy, dy, s->gz * dz)) > 0.0f);
    return lane_rays(s->x, s->y, s->z, dx, dy, dz, s->plane, select((vfloat)(-1.0f), (vfloat)(INFINITY), above));
}

/// launch : 1-D, one work-item per packet of PENCIL_WIDTH surfels first_surfel .. surfel_end and ray first_ray .. ray_end, packets side by side
/// in     : surfels of `capacity`; side^2 rays of each, random by `seed` and the surfel's number from `first_key`; a pencil set and its
///          maps of n x n; the scene and its hierarchy; low, high, volume: where centres are uniform
/// out    : rays[side^2][RAY_FIELDS][ray_capacity]
/// needs  : radiance and hits folded. A ray that meets what no pencil shows is none: its neighbours stand for it.
kernel void project_rays(global const float *surfels, int capacity, int first_surfel, int surfel_end, uint seed, uint first_key, int side,
                         int first_ray, int ray_end, global const float4 *cops, int pencil_count, global const float4 *radiance,
                         global const int2 *cells, global const int4 *groups, global const Hit *hits, global const Triangle *triangles,
                         global const float4 *planes, int n, HIERARCHY_PARAMETERS, float4 low, float4 high, float volume,
                         global float *rays, int ray_capacity) {
    const int packets = max((surfel_end - first_surfel + PENCIL_WIDTH - 1) / PENCIL_WIDTH, 1), item = get_global_id(0);
    const int k = first_ray + item / packets, offset = item % packets * PENCIL_WIDTH, first = first_surfel + offset;
    if (k >= ray_end) return;
    SurfelPacket s = load_surfels(surfels, capacity, first);
    PencilField field = {{cells, groups, hits, triangles, planes, n}, cops, radiance, pencil_count};
    CentreSpace space = {low, high, volume};
    vuint key = hash_packet((first_key + PACKET_AS_UINT(first + PACKET_LANES)) ^ seed);
    vfloat x, y;
    LaneRays r = surfel_rays(&s, key, k % side, k / side, side, &x, &y);
    vint sent = PACKET_MASK(r.nearest > 0.0f);
    float4 light[PENCIL_WIDTH];
    for (int l = 0; l < PENCIL_WIDTH; ++l) light[l] = (float4)(0.0f);
    if (PACKET_ANY(sent)) {
        lanes_trace(&r, false, nodes, leaves, triangles, planes);
        Places places = places_met(&r, triangles, planes);
        look_up(places, &field, light);
        int known[PENCIL_WIDTH];
        for (int l = 0; l < PENCIL_WIDTH; ++l) known[l] = -(light[l].w > 0.0f);
        sent &= ~places.open | PACKET_LOAD(known);
    }
    vfloat path = fmin(r.nearest, box_exit(&r, &space)), cosine = sqrt(fmax(1.0f - x * x - y * y, (vfloat)(0.0f)));
    vfloat radius = cell_radius(FREE_PATH_DENSITY(path, volume), cosine, pencil_count, side * side);
    global float *out = rays + (size_t)k * RAY_FIELDS * ray_capacity + offset;
    PACKET_STORE(x, out + (size_t)RAY_TANGENT * ray_capacity);
    PACKET_STORE(y, out + (size_t)RAY_BITANGENT * ray_capacity);
    PACKET_STORE(select((vfloat)(-1.0f), radius, sent), out + (size_t)RAY_RADIUS * ray_capacity);
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        out[(size_t)RAY_R * ray_capacity + l] = light[l].x;
        out[(size_t)RAY_G * ray_capacity + l] = light[l].y;
        out[(size_t)RAY_B * ray_capacity + l] = light[l].z;
    }
}

#endif
