// What packets of rays from one centre meet first, by a hierarchy of boxes. Coverage, disparity and ties are those of the rasteriser
// (raster.cl): both see the same triangle through the same point.

#include "lib/apart.cl"
#include "lib/packet.cl"
#include "lib/triangle.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"

/// Direction components nearer to 0 than this are taken as this where they divide.
#define BVH_TINY 1e-20f

#if PENCIL_WIDE_BVH
#include "lib/wide_bvh.cl"
#endif

/// Rays from `origin`, and what they have met so far: disparity 1/t (0: nothing), for directions of any length.
typedef struct RayPacket {
    vfloat x, y, z;             // directions
    vfloat ix, iy, iz;          // their reciprocals, finite
    vfloat disparity, nearest;  // 1/t and t of the hit
    vint triangle;              // -1: none
    float most;                 // what has a larger disparity is not there
} RayPacket;

static inline vfloat finite_reciprocal(vfloat v) { return 1.0f / copysign(fmax(fabs(v), (vfloat)(BVH_TINY)), v); }

static inline RayPacket ray_packet(vfloat x, vfloat y, vfloat z) {
    RayPacket r;
    r.x = x;
    r.y = y;
    r.z = z;
    r.ix = finite_reciprocal(x);
    r.iy = finite_reciprocal(y);
    r.iz = finite_reciprocal(z);
    r.disparity = 0.0f;
    r.nearest = INFINITY;
    r.triangle = -1;
    r.most = INFINITY;
    return r;
}

/// Lanes whose rays, with parameters x0 .. z1 at the planes of a box, meet it before `nearest`; `entry` is where.
static inline vint packet_meets_slabs(vfloat x0, vfloat x1, vfloat y0, vfloat y1, vfloat z0, vfloat z1, vfloat nearest, vfloat *entry) {
    vfloat in = fmax(fmax(fmin(x0, x1), fmin(y0, y1)), fmax(fmin(z0, z1), (vfloat)(0.0f)));
    vfloat out = fmin(fmin(fmax(x0, x1), fmax(y0, y1)), fmin(fmax(z0, z1), nearest));
    *entry = in;
    return PACKET_MASK(in <= out);
}

/// The same for a box whose corners are given relative to the origin of all rays.
static inline vint packet_meets_box(const RayPacket *r, float4 low, float4 high, vfloat *entry) {
    return packet_meets_slabs(low.x * r->ix, high.x * r->ix, low.y * r->iy, high.y * r->iy, low.z * r->iz, high.z * r->iz, r->nearest,
                              entry);
}

/// Distance from the origin within which the plane of a triangle, corners relative to the origin, passes through it: as bound_film.
static inline float edge_on_distance(float4 a, float4 b, float4 c) {
    float4 far = fmax(fabs(a), fmax(fabs(b), fabs(c)));
    return PLANE_TOLERANCE * fmin(fmax(far.x, fmax(far.y, far.z)), 1.0f);
}

/// Meets one triangle, unless its plane passes within `tolerance` of the origin; below 0: within edge_on_distance. Nearer wins, at equal
/// disparity the lower index.
static inline void packet_meet_triangle(RayPacket *r, global const Triangle *t, int index, float4 plane, float4 origin, float tolerance) {
    float ahead = plane_ahead(plane, origin);
    if (fabs(ahead) <= tolerance) return;
    float side = ahead > 0.0f ? 1.0f : -1.0f;
    float4 a = t->v0 - origin, b = t->v1 - origin, c = t->v2 - origin;
    if (tolerance < 0.0f && fabs(ahead) < edge_on_distance(a, b, c)) return;
    float4 ab = edge_normal(a, b) * side, bc = edge_normal(b, c) * side, ca = edge_normal(c, a) * side, w = plane / ahead;
    vfloat disparity = fma(r->x, (vfloat)(w.x), fma(r->y, (vfloat)(w.y), r->z * w.z));
    vint meets = PACKET_MASK(fma(r->x, (vfloat)(ab.x), fma(r->y, (vfloat)(ab.y), r->z * ab.z)) >= 0.0f) &
                 PACKET_MASK(fma(r->x, (vfloat)(bc.x), fma(r->y, (vfloat)(bc.y), r->z * bc.z)) >= 0.0f) &
                 PACKET_MASK(fma(r->x, (vfloat)(ca.x), fma(r->y, (vfloat)(ca.y), r->z * ca.z)) >= 0.0f);
    vint nearer = PACKET_MASK(disparity > r->disparity) | (PACKET_MASK(disparity == r->disparity) & PACKET_MASK(index < r->triangle));
    meets &= nearer & PACKET_MASK(disparity > 0.0f) & PACKET_MASK(disparity <= r->most);
    r->disparity = select(r->disparity, disparity, meets);
    r->nearest = select(r->nearest, 1.0f / disparity, meets);
    r->triangle = select(r->triangle, (vint)(index), meets);
}

#if PENCIL_WIDE_BVH
/// Square of the least cosine between a packet's first ray and its others, where they mostly meet the same boxes.
#define NARROW_COSINE2 0.998f

/// True if the rays are faster together than each alone.
static inline bool packet_is_narrow(const RayPacket *r) {
    float x = LANE_FLOAT(r->x, 0), y = LANE_FLOAT(r->y, 0), z = LANE_FLOAT(r->z, 0);
    vfloat along = r->x * x + r->y * y + r->z * z, squares = (r->x * r->x + r->y * r->y + r->z * r->z) * (x * x + y * y + z * z);
    return PENCIL_WIDTH > 1 && !PACKET_ANY(PACKET_MASK(along * fabs(along) < NARROW_COSINE2 * squares));
}

/// Puts the children of a node that some ray meets on the stack, what the first lane enters first on top; the new depth.
static inline int packet_push_children(const RayPacket *r, float4 origin, global const WideNode *node, int *stack, int depth) {
    float entries[WIDE_CHILDREN];
    int first = depth;
    for (int k = 0; k < WIDE_CHILDREN; ++k) {
        float4 low = (float4)(node->low[0][k], node->low[1][k], node->low[2][k], 0.0f);
        float4 high = (float4)(node->high[0][k], node->high[1][k], node->high[2][k], 0.0f);
        vfloat entry;
        if (!(low.x <= high.x) || !PACKET_ANY(packet_meets_box(r, low - origin, high - origin, &entry))) continue;
        int at = depth++;
        for (; at > first && entries[at - 1 - first] < LANE_FLOAT(entry, 0); --at) {
            stack[at] = stack[at - 1];
            entries[at - first] = entries[at - 1 - first];
        }
        stack[at] = node->child[k];
        entries[at - first] = LANE_FLOAT(entry, 0);
    }
    return depth;
}

/// The rays together, see packet_trace.
static inline void packet_trace_together(RayPacket *r, float4 origin, int own, float tolerance, HIERARCHY_PARAMETERS,
                                         global const Triangle *triangles, global const float4 *planes) {
    int stack[WIDE_STACK], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        int next = stack[--depth];
        if (next >= 0) {
            depth = packet_push_children(r, origin, nodes + next, stack, depth);
            continue;
        }
        global const WideLeaf *leaf = leaves + ~next;
        for (int k = 0; k < WIDE_TRIANGLES && leaf->triangle[k] >= 0; ++k) {
            int plane = leaf->plane_index[k];
            if (plane != own) packet_meet_triangle(r, triangles + leaf->triangle[k], leaf->triangle[k], planes[plane], origin, tolerance);
        }
    }
}
#endif

/// Follows the rays through the whole scene but for the plane `own` that they start on (-1: on none), and for planes within `tolerance` of
/// the origin; 0: planes stop rays however near they are; below 0: planes of triangles that are seen edge-on do not.
#if PENCIL_WIDE_BVH
static inline void packet_trace(RayPacket *r, float4 origin, int own, float tolerance, HIERARCHY_PARAMETERS,
                                global const Triangle *triangles, global const float4 *planes) {
    if (packet_is_narrow(r)) {
        packet_trace_together(r, origin, own, tolerance, nodes, leaves, triangles, planes);
        return;
    }
    float disparity[PENCIL_WIDTH], nearest[PENCIL_WIDTH];
    int triangle[PENCIL_WIDTH];
#pragma unroll 1
    for (int l = 0; l < PENCIL_WIDTH; ++l) {
        WideRay ray = wide_ray(origin.x, origin.y, origin.z, LANE_FLOAT(r->x, l), LANE_FLOAT(r->y, l), LANE_FLOAT(r->z, l), own);
        ray.tolerance = tolerance;
        ray.most = r->most;
        wide_trace(&ray, nodes, leaves);
        disparity[l] = ray.disparity;
        nearest[l] = ray.nearest;
        triangle[l] = ray.triangle;
    }
    r->disparity = PACKET_LOAD(disparity);
    r->nearest = PACKET_LOAD(nearest);
    r->triangle = PACKET_LOAD(triangle);
}
#else
static inline void packet_trace(RayPacket *r, float4 origin, int own, float tolerance, HIERARCHY_PARAMETERS,
                                global const Triangle *triangles, global const float4 *planes) {
    int stack[BVH_MOST_LEVELS + 1];
    int depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        global const BvhNode *node = nodes + stack[--depth];
        vfloat entry[2] = {(vfloat)(0.0f), (vfloat)(0.0f)};
        bool meets[2];
        for (int k = 0; k < 2; ++k) {
            meets[k] = PACKET_ANY(packet_meets_box(r, node->low[k] - origin, node->high[k] - origin, entry + k)) && node->child[k] >= 0;
            if (!meets[k] || node->count[k] == 0) continue;
            for (int i = node->child[k]; i < node->child[k] + node->count[k]; ++i) {
                int triangle = leaves[i];
                int plane = triangles[triangle].plane;
                if (plane != own) packet_meet_triangle(r, triangles + triangle, triangle, planes[plane], origin, tolerance);
            }
            meets[k] = false;
        }
        // The child that the first lane enters first is popped first.
        int far = LANE_FLOAT(entry[0], 0) <= LANE_FLOAT(entry[1], 0) ? 1 : 0;
        if (meets[far]) stack[depth++] = node->child[far];
        if (meets[1 - far]) stack[depth++] = node->child[1 - far];
    }
}
#endif
