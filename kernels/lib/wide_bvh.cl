// What single rays meet, by the hierarchy with eight children per node: its boxes, and the triangles of a leaf, side by side. Rays of a packet
// that look at many small triangles part soon, and then each alone is faster. Coverage is the rasteriser's (triangle.cl).

#include "lib/apart.cl"
#include "lib/packet.cl"
#include "lib/triangle.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"

/// A ray and what it has met so far.
typedef struct WideRay {
    float origin[3], direction[3], reciprocal[3];  // reciprocals of the direction, finite
    float disparity, nearest;                      // 1/t and t of the hit, or up to where hits count
    float most;                                    // what has a larger disparity is not there
    float tolerance;                               // planes within it of the origin are not met; below 0: those within edge_on_distance
    int own;                                       // plane that is not met, -1: none
    int triangle;                                  // -1: none
    bool any;                                      // the first hit ends it
    bool segment;                                  // it ends in `end`, and meets what that lies beyond by more than `beyond`
    float end[3], beyond;
} WideRay;

#if defined(__clang__) && defined(__AVX__)
#if __has_builtin(__builtin_ia32_movmskps256)
#define WIDE_AVX
#endif
#endif

/// The lanes of a mask as bits, lane 0 lowest.
static inline int wide_bits(int8 mask) {
#ifdef WIDE_AVX
    return __builtin_ia32_movmskps256(as_float8(mask));
#else
    int8 bits = mask & (int8)(1, 2, 4, 8, 16, 32, 64, 128);
    int4 half_bits = bits.lo | bits.hi;
    return half_bits.x | half_bits.y | half_bits.z | half_bits.w;
#endif
}

#define LOWEST_BIT(bits) popcount(~(bits) & ((bits)-1))
/// Room for the siblings of every node on a path.
#define WIDE_STACK ((WIDE_CHILDREN - 1) * WIDE_MOST_LEVELS + 1)

#define WIDE_LESS(a, b) ((a) < (b) ? (a) : (b))
#define WIDE_MORE(a, b) ((a) > (b) ? (a) : (b))

/// triangle.cl's edge_normal for four pairs of points: on which side of the line from p to q the ray passes.
static inline float4 wide_edge(const float *d, const float4 *p, const float4 *q) {
    float4 mx = p[0] + q[0], my = p[1] + q[1], mz = p[2] + q[2], ex = q[0] - p[0], ey = q[1] - p[1], ez = q[2] - p[2];
    float4 nx = fma(my, ez, -(mz * ey)), ny = fma(mz, ex, -(mx * ez)), nz = fma(mx, ey, -(my * ex));
    return fma((float4)(d[0]), nx, fma((float4)(d[1]), ny, d[2] * nz));
}

/// Those of four triangles whose planes are as far from the origin as they have to be.
static inline int4 wide_apart(const WideRay *r, float4 ahead, const float4 *a, const float4 *b, const float4 *c) {
    if (r->tolerance >= 0.0f) return fabs(ahead) > r->tolerance;
    float4 far = 0.0f;
    for (int k = 0; k < 3; ++k) far = fmax(far, fmax(fabs(a[k]), fmax(fabs(b[k]), fabs(c[k]))));
    return (fabs(ahead) >= PLANE_TOLERANCE * fmin(far, (float4)(1.0f))) & (ahead != 0.0f);
}

/// Meets the triangles of a leaf. Nearer wins, at equal disparity the lower index.
static inline void wide_meet_leaf(WideRay *r, global const WideLeaf *leaf) {
    float4 px = vload4(0, leaf->plane[0]), py = vload4(0, leaf->plane[1]), pz = vload4(0, leaf->plane[2]), pw = vload4(0, leaf->plane[3]);
    float4 ahead = pw - fma(px, (float4)(r->origin[0]), fma(py, (float4)(r->origin[1]), pz * r->origin[2]));
    float4 disparity =
        fma((float4)(r->direction[0]), px / ahead, fma((float4)(r->direction[1]), py / ahead, r->direction[2] * (pz / ahead)));
    int4 meets = vload4(0, leaf->plane_index) != r->own;
    if (r->segment) {
        float4 rest = pw - fma(px, (float4)(r->end[0]), fma(py, (float4)(r->end[1]), pz * r->end[2]));
        meets &= rest * copysign((float4)(1.0f), ahead) < -r->beyond;
    } else {
        meets &= (disparity >= r->disparity) & (disparity > FLT_MIN) & (disparity <= r->most);
    }
    if (!any(meets)) return;
    float4 a[3], b[3], c[3];
    for (int k = 0; k < 3; ++k) {
        a[k] = vload4(0, leaf->corner[0][k]) - r->origin[k];
        b[k] = vload4(0, leaf->corner[1][k]) - r->origin[k];
        c[k] = vload4(0, leaf->corner[2][k]) - r->origin[k];
    }
    float4 side = copysign((float4)(1.0f), ahead);
    meets &= wide_apart(r, ahead, a, b, c) & (side * wide_edge(r->direction, a, b) >= 0.0f) &
             (side * wide_edge(r->direction, b, c) >= 0.0f) & (side * wide_edge(r->direction, c, a) >= 0.0f);
    if (!any(meets)) return;
    for (int k = 0; k < WIDE_TRIANGLES; ++k) {
        float at = LANE_FLOAT(disparity, k);
        int triangle = leaf->triangle[k];
        if (!LANE_INT(meets, k) || at < r->disparity || (at == r->disparity && (r->triangle < 0 || triangle > r->triangle))) continue;
        r->disparity = at;
        r->nearest = 1.0f / at;
        r->triangle = triangle;
    }
}

/// Children of a node that the ray meets before what it has met, as bits, and where it enters them.
static inline int wide_meet_boxes(const WideRay *r, global const WideNode *node, float *entry) {
    float8 in = 0.0f, out = r->nearest;
    for (int k = 0; k < 3; ++k) {
        bool forward = r->reciprocal[k] >= 0.0f;
        float8 near = (vload8(0, forward ? node->low[k] : node->high[k]) - r->origin[k]) * r->reciprocal[k];
        float8 far = (vload8(0, forward ? node->high[k] : node->low[k]) - r->origin[k]) * r->reciprocal[k];
        in = WIDE_MORE(near, in);
        out = WIDE_LESS(far, out);
    }
    vstore8(in, 0, entry);
    return wide_bits(in <= out);
}

/// Asks for what a child is, that is looked at soon.
static inline void wide_prefetch(global const WideNode *nodes, global const WideLeaf *leaves, int child) {
    global const char *p = child >= 0 ? (global const char *)(nodes + child) : (global const char *)(leaves + ~child);
    PREFETCH(p);
    PREFETCH(p + 64);
    PREFETCH(p + 128);
    PREFETCH(p + 192);
}

/// Follows the ray through the scene.
APART static void wide_trace(WideRay *r, global const WideNode *nodes, global const WideLeaf *leaves) {
    int stack[WIDE_STACK];
    float entries[WIDE_STACK], entry[WIDE_CHILDREN];
    int depth = 0, next = 0;
    // NaN would meet boxes that are not there.
    if (!isfinite(r->origin[0] + r->origin[1] + r->origin[2] + r->direction[0] + r->direction[1] + r->direction[2])) return;
    while (true) {
        if (next < 0) {
            wide_meet_leaf(r, leaves + ~next);
            if (r->any && r->triangle >= 0) return;
        } else {
            global const WideNode *node = nodes + next;
            int bits = wide_meet_boxes(r, node, entry), first = depth;
            for (; bits; bits &= bits - 1) {
                // The nearest ends on top.
                int k = LOWEST_BIT(bits), at = depth++, child = node->child[k];
                wide_prefetch(nodes, leaves, child);
                for (; at > first && entries[at - 1] < entry[k]; --at) {
                    stack[at] = stack[at - 1];
                    entries[at] = entries[at - 1];
                }
                stack[at] = child;
                entries[at] = entry[k];
            }
        }
        do {
            if (depth == 0) return;
            next = stack[--depth];
        } while (entries[depth] > r->nearest);
    }
}

/// The ray of a lane, which nothing limits.
static inline WideRay wide_ray(float ox, float oy, float oz, float x, float y, float z, int own) {
    WideRay r;
    r.origin[0] = ox;
    r.origin[1] = oy;
    r.origin[2] = oz;
    r.direction[0] = x;
    r.direction[1] = y;
    r.direction[2] = z;
    for (int k = 0; k < 3; ++k) r.reciprocal[k] = 1.0f / copysign(fmax(fabs(r.direction[k]), BVH_TINY), r.direction[k]);
    r.disparity = r.tolerance = 0.0f;
    r.nearest = r.most = INFINITY;
    r.own = own;
    r.triangle = -1;
    r.any = r.segment = false;
    return r;
}
