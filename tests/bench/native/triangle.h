// Exact incidence of lines and triangles (kernels/lib/triangle.cl), scalar.
#pragma once

#include "bench/native/simd.h"
#include "bench/native/views.h"

namespace pencil::native {

constexpr float plane_tolerance = 1e-6F;

/// Keeps the compiler from contracting the product into a multiply-add.
inline void round_here(float4v& v) {
#if defined(__x86_64__)
    __asm__("" : "+v"(v));
#else
    __asm__("" : "+w"(v));
#endif
}

inline float4v yzx(float4v v) { return __builtin_shufflevector(v, v, 1, 2, 0, 3); }
inline float4v zxy(float4v v) { return __builtin_shufflevector(v, v, 2, 0, 1, 3); }

/// Twice cross(p, q), exactly the negative of edge_normal(q, p).
inline float4v edge_normal(float4v p, float4v q) {
    const float4v m = p + q, e = q - p;
    float4v a = yzx(m) * zxy(e);
    float4v b = zxy(m) * yzx(e);
    round_here(a);
    round_here(b);
    return a - b;
}

inline float plane_ahead(const float4& plane, float4v p) {
    return plane.w - __builtin_fmaf(plane.x, p[0], __builtin_fmaf(plane.y, p[1], plane.z * p[2]));
}

/// True if the line from `origin` along `direction` passes through the triangle or its border; `side`: sign of plane_ahead(origin).
inline bool line_meets_triangle(const Triangle& t, float4v origin, float4v direction, float side) {
    const float4v a = load_point(t.v0) - origin, b = load_point(t.v1) - origin, c = load_point(t.v2) - origin;
    const float4v d = direction * side;
    return dot3(edge_normal(a, b), d) >= 0.0F && dot3(edge_normal(b, c), d) >= 0.0F && dot3(edge_normal(c, a), d) >= 0.0F;
}

}  // namespace pencil::native
