// What rays meet that start in different places: packets of them through the hierarchy. Slower than packets from one centre (bvh.cl), and as
// exact near each ray's own origin, however far away the scene goes on. Coverage is the rasteriser's: two triangles that share an edge leave
// no gap.

#include "lib/bvh.cl"
#include "lib/packet.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"

/// Rays by lane. Lanes with nearest < 0 meet nothing.
typedef struct LaneRays {
    vfloat ox, oy, oz;  // origins
    vfloat x, y, z;     // directions, of any length
    vfloat ix, iy, iz;  // their reciprocals, finite
    vfloat nearest;     // ray parameter of the hit, or up to which hits count
    vint own;           // plane that a ray starts on and does not meet
    vint triangle;      // -1: none
} LaneRays;

static inline LaneRays lane_rays(vfloat ox, vfloat oy, vfloat oz, vfloat x, vfloat y, vfloat z, vint own, vfloat nearest) {
    LaneRays r;
    r.ox = ox;
    r.oy = oy;
    r.oz = oz;
    r.x = x;
    r.y = y;
    r.z = z;
    r.ix = finite_reciprocal(x);
    r.iy = finite_reciprocal(y);
    r.iz = finite_reciprocal(z);
    r.nearest = nearest;
    r.own = own;
    r.triangle = -1;
    return r;
}

/// Lanes whose rays meet a box before what they have met; `entry` is where.
static inline vint lanes_meet_box(const LaneRays *r, float4 low, float4 high, vfloat *entry) {
    return packet_meets_slabs((low.x - r->ox) * r->ix, (high.x - r->ox) * r->ix, (low.y - r->oy) * r->iy, (high.y - r->oy) * r->iy,
                              (low.z - r->oz) * r->iz, (high.z - r->oz) * r->iz, r->nearest, entry);
}

/// On which side of the line from p to q each ray passes: dot of its direction and cross(p + q, q - p), as edge_normal of triangle.cl.
static inline vfloat lane_edge(const LaneRays *r, vfloat px, vfloat py, vfloat pz, vfloat qx, vfloat qy, vfloat qz) {
    vfloat mx = px + qx, my = py + qy, mz = pz + qz, ex = qx - px, ey = qy - py, ez = qz - pz;
    vfloat nx = fma(my, ez, -(mz * ey)), ny = fma(mz, ex, -(mx * ez)), nz = fma(mx, ey, -(my * ex));
    return fma(r->x, nx, fma(r->y, ny, r->z * nz));
}

/// Meets one triangle, unless its plane passes within the rounding of the origin. The nearest wins; at equal distance the one that came first.
static inline void lanes_meet_triangle(LaneRays *r, global const Triangle *t, int index, float4 plane, int plane_index) {
    vfloat ahead = plane.w - fma((vfloat)(plane.x), r->ox, fma((vfloat)(plane.y), r->oy, plane.z * r->oz));
    vfloat distance = ahead / fma((vfloat)(plane.x), r->x, fma((vfloat)(plane.y), r->y, plane.z * r->z));
    // Where surfaces coincide, a ray does not meet the one that it has not started on either.
    vfloat rounding = POSITION_ERROR * fmax(fabs(r->ox), fmax(fabs(r->oy), fabs(r->oz)));
    vint meets = PACKET_MASK(fabs(ahead) > rounding) & PACKET_MASK(distance > 0.0f) & PACKET_MASK(distance < r->nearest) &
                 PACKET_MASK(r->own != plane_index);
    if (!PACKET_ANY(meets)) return;
    vfloat ax = t->v0.x - r->ox, ay = t->v0.y - r->oy, az = t->v0.z - r->oz, bx = t->v1.x - r->ox, by = t->v1.y - r->oy,
           bz = t->v1.z - r->oz, cx = t->v2.x - r->ox, cy = t->v2.y - r->oy, cz = t->v2.z - r->oz;
    vfloat side = copysign((vfloat)(1.0f), ahead);
    meets &= PACKET_MASK(side * lane_edge(r, ax, ay, az, bx, by, bz) >= 0.0f) &
             PACKET_MASK(side * lane_edge(r, bx, by, bz, cx, cy, cz) >= 0.0f) &
             PACKET_MASK(side * lane_edge(r, cx, cy, cz, ax, ay, az) >= 0.0f);
    r->nearest = select(r->nearest, distance, meets);
    r->triangle = select(r->triangle, (vint)(index), meets);
}

/// Follows the rays to the nearest triangles, or, with `any`, until each open lane has met one.
#if PENCIL_WIDE_BVH
static inline void lanes_trace(LaneRays *r, bool any, HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes) {
    float nearest[PENCIL_WIDTH];
    int triangle[PENCIL_WIDTH];
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        nearest[l] = LANE_FLOAT(r->nearest, l);
        triangle[l] = LANE_INT(r->triangle, l);
        if (nearest[l] < 0.0f) continue;
        WideRay ray = wide_ray(LANE_FLOAT(r->ox, l), LANE_FLOAT(r->oy, l), LANE_FLOAT(r->oz, l), LANE_FLOAT(r->x, l), LANE_FLOAT(r->y, l),
                               LANE_FLOAT(r->z, l), LANE_INT(r->own, l));
        ray.tolerance = POSITION_ERROR * fmax(fabs(ray.origin[0]), fmax(fabs(ray.origin[1]), fabs(ray.origin[2])));
        ray.nearest = nearest[l];
        ray.disparity = 1.0f / nearest[l];
        ray.any = any;
        wide_trace(&ray, nodes, leaves);
        nearest[l] = any && ray.triangle >= 0 ? -1.0f : ray.nearest;
        triangle[l] = ray.triangle;
    }
    r->nearest = PACKET_LOAD(nearest);
    r->triangle = PACKET_LOAD(triangle);
}
#else
static inline void lanes_trace(LaneRays *r, bool any, HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes) {
    int stack[BVH_MOST_LEVELS + 1];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        global const BvhNode *node = nodes + stack[--depth];
        vfloat entry[2] = {(vfloat)(0.0f), (vfloat)(0.0f)};
        bool meets[2];
        for (int k = 0; k < 2; ++k) {
            meets[k] = node->child[k] >= 0 && PACKET_ANY(lanes_meet_box(r, node->low[k], node->high[k], entry + k));
            if (!meets[k] || node->count[k] == 0) continue;
            for (int i = node->child[k]; i < node->child[k] + node->count[k]; ++i) {
                int triangle = leaves[i], plane = triangles[triangle].plane;
                lanes_meet_triangle(r, triangles + triangle, triangle, planes[plane], plane);
            }
            if (any) r->nearest = select(r->nearest, (vfloat)(-1.0f), PACKET_MASK(r->triangle >= 0));
            meets[k] = false;
        }
        int far = LANE_FLOAT(entry[0], 0) <= LANE_FLOAT(entry[1], 0) ? 1 : 0;
        if (meets[far]) stack[depth++] = node->child[far];
        if (meets[1 - far]) stack[depth++] = node->child[1 - far];
    }
}
#endif
