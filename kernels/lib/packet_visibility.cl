// Visibility of packets of surfels from one centre, by the rules of visibility.cl. Cells settle most lanes; what they leave open is settled
// for all lanes at once that share a blocker, then for all lanes at once that share the triangles about their footprints: neighbouring
// lanes mostly do. Sets of lanes are bits of an int here. With PENCIL_BVH there are no maps: rays through the
// hierarchy settle everything, exactly.

#include "lib/bvh.cl"
#include "lib/footprint.cl"
#include "lib/map.cl"
#include "lib/packet.cl"
#include "lib/rays.cl"
#include "lib/shadow.cl"
#include "lib/surfel_packet.cl"
#include "lib/triangle.cl"
#include "lib/visibility.cl"
#include "shared/atlas.h"
#include "shared/bvh.h"
#include "shared/geometry.h"
#include "shared/light.h"

/// A shadow ray passes planes that its surfel is beyond by less than this: rounding of positions [scene units].
#define SHADOW_TOLERANCE 1e-7f

/// A packet of surfels as a tile meets it. A block of packets is aimed before the first is tested, so that the memory which the tests need
/// is on its way: the maps of a set are larger than the near caches.
typedef struct Aimed {
    Footprint f;    // index: from the first texel of all tiles
    vfloat weight;  // of what the surfels receive from there; the caller's
    int faces;      // lanes that face the centre
} Aimed;

/// Footprints in `tile` of the directions v. Neighbouring lanes mostly share the cache line of their cells.
static inline void aim_packet(const VisibilityMap *map, int tile, vfloat vx, vfloat vy, vfloat vz, Aimed *aimed) {
    if (PENCIL_BVH) return;
    aimed->f = map_footprint_in(tile, vx, vy, vz, map->n);
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; l += 2) PREFETCH(map->cells + LANE_INT(aimed->f.index, l));
}

/// Lanes that lie behind `plane` as seen from `cop`.
static inline int packet_behind(const SurfelPacket *s, float4 plane, float4 cop) {
    if (plane_ahead(plane, cop) <= 0.0f) plane = -plane;
    vfloat ahead = plane.w - fma(s->x, (vfloat)(plane.x), fma(s->y, (vfloat)(plane.y), s->z * plane.z));
    return PACKET_BITS(PACKET_MASK(ahead <= -PLANE_TOLERANCE));
}

/// Lanes whose line from `cop` passes through the triangle or its border; `side` is the sign of plane_ahead(cop).
static inline int packet_meets_triangle(const SurfelPacket *s, global const Triangle *t, float4 cop, float side) {
    float4 a = t->v0 - cop, b = t->v1 - cop, c = t->v2 - cop;
    float4 ab = edge_normal(a, b) * side, bc = edge_normal(b, c) * side, ca = edge_normal(c, a) * side;
    vfloat x = s->x - cop.x, y = s->y - cop.y, z = s->z - cop.z;
    vfloat in_ab = fma(x, (vfloat)(ab.x), fma(y, (vfloat)(ab.y), z * ab.z));
    vfloat in_bc = fma(x, (vfloat)(bc.x), fma(y, (vfloat)(bc.y), z * bc.z));
    vfloat in_ca = fma(x, (vfloat)(ca.x), fma(y, (vfloat)(ca.y), z * ca.z));
    return PACKET_BITS(PACKET_MASK(fmin(fmin(in_ab, in_bc), in_ca) >= 0.0f));
}

/// Those of `lanes` whose segment from `cop` crosses a triangle of the group that begins with triangle `index` in front of the surfel. The group
/// holds the mates, on both sides, of one that the footprint shows: it ends where the mates of the first one's last mate do, at the latest.
static inline int packet_crosses(const SurfelPacket *s, const VisibilityMap *map, int index, float4 cop, int lanes) {
    global const Triangle *first = map->triangles + index;
    float4 plane = map->planes[first->plane];
    float ahead = plane_ahead(plane, cop);
    lanes &= packet_behind(s, plane, cop);
    if (ahead == 0.0f || !lanes) return 0;
    int last = MATES_AFTER(first->mates), crosses = 0;
    last += MATES_AFTER(first[last].mates);
#pragma unroll 1
    for (int t = 0; t <= last && (crosses & lanes) != lanes; ++t)
        crosses |= packet_meets_triangle(s, first + t, cop, ahead > 0.0f ? 1.0f : -1.0f);
    return crosses & lanes;
}

/// Those of `lanes` that are seen past `group`, the triangles about the footprint of each of them; `inner`: for each triangle, lanes whose
/// footprint itself shows it.
static inline int seen_past_group(const SurfelPacket *s, const VisibilityMap *map, const Footprint *f, int tile, float4 cop,
                                  const int *group, const int *inner, int lanes) {
    int shown = 0;
    for (int g = 0; g < MOST_GROUPS && group[g] >= 0 && lanes; ++g) {
        int own = lanes & PACKET_BITS(PACKET_MASK(s->plane == map->triangles[group[g]].plane));
        shown |= own & inner[g];
        if (own != lanes) lanes &= ~packet_crosses(s, map, group[g], cop, lanes & ~own);
    }
    for (int unsure = lanes & ~shown; unsure; unsure &= unsure - 1) {
        int l = LOWEST_LANE(unsure);
        if (hiding_weight(map, tile, footprint_corner(f, l), LANE_FLOAT(f->fx, l), LANE_FLOAT(f->fy, l), cop, surfel_position(s, l),
                          LANE_INT(s->plane, l)) > 0.5f)
            lanes &= ~(1 << l);
    }
    return lanes;
}

/// Lanes that lie on another plane than number `own` and beyond it, as seen from a centre to which it is `ahead`. No more tolerance than
/// rounding: what lies in a crease is not to see past the other wall.
static inline int packet_beyond(const SurfelPacket *s, int own, float4 plane, float ahead) {
    vfloat distance = plane.w - fma(s->x, (vfloat)(plane.x), fma(s->y, (vfloat)(plane.y), s->z * plane.z));
    return PACKET_BITS(PACKET_MASK(distance * copysign(1.0f, ahead) < -SHADOW_TOLERANCE) & PACKET_MASK(s->plane != own));
}

/// A centre so many times as far from the eye as a surfel is: rays that start at the centre would know the surfel's surroundings badly.
#define FAR_CENTRE 256.0f
/// Rays to a far centre end this share before it.
#define FAR_END 0.9999f

/// True if rays should start at the surfels. Scene units are centred on the eye.
static inline bool centre_is_far(const SurfelPacket *s, float4 cop) {
    float3 x = surfel_position(s, 0).xyz;
    return dot(cop.xyz, cop.xyz) > FAR_CENTRE * FAR_CENTRE * dot(x, x);
}

/// Those of `open` that are seen from a far `cop`.
static inline vfloat share_from_surfels(const SurfelPacket *s, const VisibilityMap *map, float4 cop, int open) {
    vfloat end = select((vfloat)(-1.0f), (vfloat)(FAR_END), PACKET_FROM_BITS(open));
    LaneRays rays = lane_rays(s->x, s->y, s->z, cop.x - s->x, cop.y - s->y, cop.z - s->z, s->plane, end);
    return rays_share(&rays, open, map->scene, map->nodes, map->leaves, map->triangles, map->planes);
}

/// Those of `open` that light travelling in direction d from infinitely far away reaches.
static inline vfloat share_along(const SurfelPacket *s, const VisibilityMap *map, float3 d, int open) {
    if (!open) return 0.0f;
    vfloat end = select((vfloat)(-1.0f), (vfloat)(INFINITY), PACKET_FROM_BITS(open));
    LaneRays rays = lane_rays(s->x, s->y, s->z, (vfloat)(-d.x), (vfloat)(-d.y), (vfloat)(-d.z), s->plane, end);
    return rays_share(&rays, open, map->scene, map->nodes, map->leaves, map->triangles, map->planes);
}

/// Those of `open` that a triangle hides from `cop`.
static inline int hidden_by(const SurfelPacket *s, const VisibilityMap *map, int index, float4 cop, int open) {
    global const Triangle *triangle = map->triangles + index;
    float4 plane = map->planes[triangle->plane];
    float ahead = plane_ahead(plane, cop);
    int behind = fabs(ahead) < PLANE_TOLERANCE ? 0 : open & packet_beyond(s, triangle->plane, plane, ahead);
    return behind ? behind & packet_meets_triangle(s, triangle, cop, ahead > 0.0f ? 1.0f : -1.0f) : 0;
}

#if PENCIL_WIDE_BVH
/// Those of `open` that are seen from `cop`, each by a ray alone.
static inline int settle_each(const SurfelPacket *s, const VisibilityMap *map, float4 cop, int open) {
    for (int rest = open; rest; rest &= rest - 1) {
        int l = LOWEST_LANE(rest);
        float4 x = surfel_position(s, l);
        WideRay ray = wide_ray(cop.x, cop.y, cop.z, x.x - cop.x, x.y - cop.y, x.z - cop.z, LANE_INT(s->plane, l));
        ray.tolerance = PLANE_TOLERANCE;
        ray.nearest = 1.0f;
        ray.any = ray.segment = true;
        ray.end[0] = x.x;
        ray.end[1] = x.y;
        ray.end[2] = x.z;
        ray.beyond = SHADOW_TOLERANCE;
        wide_trace(&ray, map->nodes, map->leaves);
        if (ray.triangle >= 0) open &= ~(1 << l);
    }
    return open;
}
#endif

/// The same by rays that stay together.
static inline int settle_together(const SurfelPacket *s, const VisibilityMap *map, RayPacket *rays, float4 cop, int open) {
#if PENCIL_WIDE_BVH
    int stack[WIDE_STACK], depth = 0;
    stack[depth++] = 0;
    while (depth > 0 && open) {
        int next = stack[--depth];
        rays->nearest = select((vfloat)(-1.0f), (vfloat)(1.0f), PACKET_FROM_BITS(open));
        if (next >= 0) {
            depth = packet_push_children(rays, cop, map->nodes + next, stack, depth);
            continue;
        }
        global const WideLeaf *leaf = map->leaves + ~next;
        for (int k = 0; k < WIDE_TRIANGLES && leaf->triangle[k] >= 0; ++k) open &= ~hidden_by(s, map, leaf->triangle[k], cop, open);
    }
#else
    int stack[BVH_MOST_LEVELS + 1], depth = 0;
    stack[depth++] = 0;
    while (depth > 0 && open) {
        global const BvhNode *node = map->nodes + stack[--depth];
        rays->nearest = select((vfloat)(-1.0f), (vfloat)(1.0f), PACKET_FROM_BITS(open));
        for (int k = 0; k < 2; ++k) {
            vfloat entry;
            if (node->child[k] < 0 || !PACKET_ANY(packet_meets_box(rays, node->low[k] - cop, node->high[k] - cop, &entry))) continue;
            if (node->count[k] == 0) stack[depth++] = node->child[k];
            for (int i = node->child[k]; i < node->child[k] + node->count[k]; ++i) open &= ~hidden_by(s, map, map->leaves[i], cop, open);
        }
    }
#endif
    return open;
}

/// Those of `open` that are seen from `cop`, by rays through the hierarchy of the scene.
static inline int settle_by_rays(const SurfelPacket *s, const VisibilityMap *map, float4 cop, int open) {
    if (open && centre_is_far(s, cop)) return PACKET_BITS(PACKET_MASK(share_from_surfels(s, map, cop, open) > 0.0f));
    RayPacket rays = ray_packet(s->x - cop.x, s->y - cop.y, s->z - cop.z);
#if PENCIL_WIDE_BVH
    if (!packet_is_narrow(&rays)) return settle_each(s, map, cop, open);
#endif
    return settle_together(s, map, &rays, cop, open);
}

/// Those of `open` that are seen although neither their cells nor a plane settle it, by rules 1 to 3 of visibility.cl.
static inline int settle_by_triangles(const SurfelPacket *s, const VisibilityMap *map, const Footprint *f, int tile, float4 cop, int open) {
    int seen = 0;
    while (open) {
        int lead = LOWEST_LANE(open);
        int4 first = map->groups[LANE_INT(f->index, lead)];
        if (first.x == CELL_MIXED) {
            open &= open - 1;
            if (crowded_footprint_visible(map, tile, footprint_corner(f, lead), LANE_FLOAT(f->fx, lead), LANE_FLOAT(f->fy, lead), cop,
                                          surfel_position(s, lead), LANE_INT(s->plane, lead)))
                seen |= 1 << lead;
            continue;
        }
        int alike = 0, group[MOST_GROUPS], inner[MOST_GROUPS] = {0, 0, 0, 0};
        for (int rest = open; rest; rest &= rest - 1) {
            int l = LOWEST_LANE(rest);
            int4 about = map->groups[LANE_INT(f->index, l)], differs = (about ^ first) & ~GROUP_INNER;
            if (differs.x | differs.y | differs.z | differs.w) continue;
            alike |= 1 << l;
            int4 shows = (about & GROUP_INNER) != 0;
            inner[0] |= (shows.x & 1) << l;
            inner[1] |= (shows.y & 1) << l;
            inner[2] |= (shows.z & 1) << l;
            inner[3] |= (shows.w & 1) << l;
        }
        vstore4(select(first & ~GROUP_INNER, first, first < 0), 0, group);
        open &= ~alike;
        seen |= seen_past_group(s, map, f, tile, cop, group, inner, alike);
    }
    return seen;
}

/// Those of `open`, lanes which their cells (first, second) do not show, that are seen nevertheless. Lanes with the same blocking plane are
/// settled at once; what lies behind the other plane of a pair, or sees three planes, is left to the triangles.
static inline int settle_by_planes(const SurfelPacket *s, const VisibilityMap *map, const Footprint *f, int tile, float4 cop, vint first,
                                   vint second, int open) {
    vint pair = CELL_PAIR(second);
    vint filled = PACKET_MASK(first == second) & PACKET_MASK(first >= 0);
    vint blocker = select((vint)(CELL_MIXED), first, filled | PACKET_MASK(pair == s->plane));
    blocker = select(blocker, pair, PACKET_MASK(first == s->plane) & PACKET_MASK(second <= CELL_PAIR(0)));
    int filled_lanes = PACKET_BITS(filled), unsettled = open & PACKET_BITS(PACKET_MASK(blocker < 0)), seen = 0;
    for (int rest = open & ~unsettled; rest;) {
        int other = LANE_INT(blocker, LOWEST_LANE(rest));
        int alike = rest & PACKET_BITS(PACKET_MASK(blocker == other)), behind = packet_behind(s, map->planes[other], cop);
        seen |= alike & ~behind;
        unsettled |= alike & behind & ~filled_lanes;
        rest &= ~alike;
    }
    return unsettled ? seen | settle_by_triangles(s, map, f, tile, cop, unsettled) : seen;
}

/// Lanes of an aimed packet that are seen from `cop`, the centre of `tile`.
static inline int packet_visible(const SurfelPacket *s, const VisibilityMap *map, const Aimed *aimed, int tile, float4 cop) {
    if (!aimed->faces) return 0;
    if (PENCIL_BVH) return settle_by_rays(s, map, cop, aimed->faces);
    int cells[2 * PENCIL_WIDTH];
#pragma unroll
    for (int l = 0; l < PENCIL_WIDTH; ++l) vstore2(map->cells[LANE_INT(aimed->f.index, l)], l, cells);
    vint first, second;
    PACKET_LOAD_PAIRS(cells, first, second);
    vint shown = (PACKET_MASK(first == s->plane) | PACKET_MASK(second == s->plane)) & PACKET_MASK(second >= -1);
    int seen = aimed->faces & PACKET_BITS(shown), open = aimed->faces & ~seen;
    return open ? seen | settle_by_planes(s, map, &aimed->f, tile, cop, first, second, open) : seen;
}

/// The share of light of a sample that reaches those of `open` lanes, by rays.
static inline vfloat sample_share_by_rays(const SurfelPacket *s, const VisibilityMap *map, global const LightSample *sample, int open) {
    float4 cop = (float4)(sample->position.xyz, 0.0f);
    if (PENCIL_FAR_LIGHT && sample->position.w == LIGHT_INFINITE) return share_along(s, map, cop.xyz, open);
#if PENCIL_CLEAR
    return open ? share_from_surfels(s, map, cop, open) : (vfloat)(0.0f);
#else
    return select((vfloat)(0.0f), (vfloat)(1.0f), PACKET_FROM_BITS(settle_by_rays(s, map, cop, open)));
#endif
}

/// The same for an aimed packet, by rays or by the map of sample number i.
static inline vfloat sample_share(const SurfelPacket *s, const VisibilityMap *map, const Aimed *aimed, int i,
                                  global const LightSample *sample) {
    if (PENCIL_BVH) return sample_share_by_rays(s, map, sample, aimed->faces);
    float4 cop = (float4)(sample->position.xyz, 0.0f);
    return select((vfloat)(0.0f), (vfloat)(1.0f), PACKET_FROM_BITS(packet_visible(s, map, aimed, i, cop)));
}
