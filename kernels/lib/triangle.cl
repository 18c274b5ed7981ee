// Exact incidence of a line through a centre of projection with a triangle. Edge functions are antisymmetric to the last bit, so that
// two triangles that share an edge leave no gap between them.

#include "shared/geometry.h"

/// Distances below this are rounding: coordinates are at most 1 in magnitude, so a plane distance carries a few times 6e-8 [scene units].
#define PLANE_TOLERANCE 1e-6f

/// Twice cross(p, q), computed as cross(p + q, q - p): exactly the negative of edge_normal(q, p), and without cancellation when p and q
/// are near each other. p + q stays and q - p turns round with p and q, so one product that is rounded and one that is not keep the symmetry,
/// as long as it is always the same one: hence the fma, which leaves no contraction to the compiler.
static inline float4 edge_normal(float4 p, float4 q) {
    float4 m = p + q;
    float4 e = q - p;
    float4 r = fma(m.yzxw, e.zxyw, -(m.zxyw * e.yzxw));
    r.w = 0.0f;
    return r;
}

/// Signed distance of a point from a plane along the plane's normal, negated: positive in front of nothing but "ahead of" the point.
static inline float plane_ahead(float4 plane, float4 point) {
    return plane.w - fma(plane.x, point.x, fma(plane.y, point.y, plane.z * point.z));
}

/// True if the line from `origin` along `direction` passes through the triangle or its border; `side` is the sign of plane_ahead(origin).
static inline bool line_meets_triangle(global const Triangle *t, float4 origin, float4 direction, float side) {
    float4 a = t->v0 - origin;
    float4 b = t->v1 - origin;
    float4 c = t->v2 - origin;
    float3 d = direction.xyz * side;
    return dot(edge_normal(a, b).xyz, d) >= 0.0f && dot(edge_normal(b, c).xyz, d) >= 0.0f && dot(edge_normal(c, a).xyz, d) >= 0.0f;
}
