// Vectors of rays from one centre through the hierarchy of boxes (kernels/lib/bvh.cl).
#pragma once

#include "bench/native/surface_pencil.h"
#include "bench/native/triangle.h"
#include "bench/native/visibility.h"

namespace pencil::native {

struct Rays {
    vfloat x, y, z, ix, iy, iz;                         // directions and their reciprocals, finite
    vfloat disparity{}, nearest = broadcast(infinite);  // 1/t and t of what was met
    vint triangle = broadcast(-1);

    Rays(vfloat dx, vfloat dy, vfloat dz) : x(dx), y(dy), z(dz), ix(reciprocal(dx)), iy(reciprocal(dy)), iz(reciprocal(dz)) {}

private:
    static vfloat reciprocal(vfloat v) { return 1.0F / copy_sign(maximum(absolute(v), broadcast(1e-20F)), v); }
};

/// Lanes that meet a box before what they have met; `entry`: where.
inline unsigned meets_box(const Rays& r, const float4& low, const float4& high, float4v origin, vfloat& entry) {
    const vfloat x0 = (low.x - origin[0]) * r.ix, x1 = (high.x - origin[0]) * r.ix, y0 = (low.y - origin[1]) * r.iy,
                 y1 = (high.y - origin[1]) * r.iy, z0 = (low.z - origin[2]) * r.iz, z1 = (high.z - origin[2]) * r.iz;
    entry = maximum(maximum(minimum(x0, x1), minimum(y0, y1)), maximum(minimum(z0, z1), broadcast(0.0F)));
    const vfloat out = minimum(minimum(maximum(x0, x1), maximum(y0, y1)), minimum(maximum(z0, z1), r.nearest));
    return lane_mask(entry <= out);
}

/// Lanes whose lines pass through the triangle or its border.
inline vint through_triangle(const Rays& r, const Triangle& t, float4v origin, float side) {
    const float4v a = load_point(t.v0) - origin, b = load_point(t.v1) - origin, c = load_point(t.v2) - origin;
    const float4v ab = edge_normal(a, b) * side, bc = edge_normal(b, c) * side, ca = edge_normal(c, a) * side;
    const auto inside = [&](float4v e) { return e[0] * r.x + e[1] * r.y + e[2] * r.z; };
    return minimum(minimum(inside(ab), inside(bc)), inside(ca)) >= 0.0F;
}

inline void meet_triangle(Rays& r, const Triangle& t, int index, const float4& plane, float4v origin) {
    const float ahead = plane_ahead(plane, origin);
    if (ahead == 0.0F) return;
    const vfloat disparity = (r.x * plane.x + r.y * plane.y + r.z * plane.z) / ahead;
    const vint nearer = ((disparity > r.disparity) | ((disparity == r.disparity) & (index < r.triangle))) & (disparity > 0.0F);
    const vint meets = nearer & through_triangle(r, t, origin, ahead > 0.0F ? 1.0F : -1.0F);
    r.disparity = meets ? disparity : r.disparity;
    r.nearest = meets ? 1.0F / disparity : r.nearest;
    r.triangle = meets ? broadcast(index) : r.triangle;
}

/// What the rays meet first, but for the plane `own`.
inline void trace(Rays& r, float4v origin, int own, const SceneView& scene, const BvhView& bvh) {
    int stack[BVH_MOST_LEVELS + 1], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const BvhNode& node = bvh.nodes[stack[--depth]];
        vfloat entry[2] = {};
        bool meets[2];
        for (int k = 0; k < 2; ++k) {
            meets[k] = node.child[k] >= 0 && meets_box(r, node.low[k], node.high[k], origin, entry[k]) != 0;
            if (!meets[k] || node.count[k] == 0) continue;
            for (int i = node.child[k]; i < node.child[k] + node.count[k]; ++i) {
                const int index = bvh.leaves[i], plane = scene.triangles[index].plane;
                if (plane != own) meet_triangle(r, scene.triangles[index], index, scene.planes[plane], origin);
            }
            meets[k] = false;
        }
        const int far = entry[0][0] <= entry[1][0] ? 1 : 0;
        if (meets[far]) stack[depth++] = node.child[far];
        if (meets[1 - far]) stack[depth++] = node.child[1 - far];
    }
}

/// Those of `open` whose segments from `cop` nothing crosses; triangles on a surfel's own plane do not count.
inline unsigned unhidden(const SurfelVectors& s, float4v cop, const SceneView& scene, const BvhView& bvh, unsigned open) {
    Rays r(s.x - cop[0], s.y - cop[1], s.z - cop[2]);
    int stack[BVH_MOST_LEVELS + 1], depth = 0;
    stack[depth++] = 0;
    while (depth > 0 && open != 0) {
        const BvhNode& node = bvh.nodes[stack[--depth]];
        r.nearest = lanes_of(open) ? broadcast(1.0F) : broadcast(-1.0F);
        for (int k = 0; k < 2; ++k) {
            vfloat entry;
            if (node.child[k] < 0 || meets_box(r, node.low[k], node.high[k], cop, entry) == 0) continue;
            if (node.count[k] == 0) stack[depth++] = node.child[k];
            for (int i = node.child[k]; i < node.child[k] + node.count[k]; ++i) {
                const Triangle& t = scene.triangles[bvh.leaves[i]];
                const float4& plane = scene.planes[t.plane];
                const float ahead = plane_ahead(plane, cop);
                if (std::abs(ahead) < plane_tolerance) continue;
                const float side = ahead > 0.0F ? 1.0F : -1.0F;
                const vfloat behind = side * (plane.w - (plane.x * s.x + plane.y * s.y + plane.z * s.z));
                const unsigned crossing = open & lane_mask((behind <= -plane_tolerance) & (s.plane != t.plane));
                if (crossing != 0) open &= ~(crossing & lane_mask(through_triangle(r, t, cop, side)));
            }
        }
    }
    return open;
}

}  // namespace pencil::native
