// One tile at a time in the nearest cache; bounding boxes of clipped triangles in each octant, as the kernel.
#include "bench/native/native.h"
#include "bench/native/octahedral.h"
#include "bench/native/parallel.h"
#include "bench/native/raster.h"

namespace pencil::native {
namespace {

constexpr float box_slack = 1e-2F, box_trusted_distance = 1e-2F;

struct Octant {
    float4v sign;
    bool front;
    RasterFrame frame;
};

Octant make_octant(int index) {
    const float sx = (index & 1) != 0 ? -1.0F : 1.0F, sy = (index & 2) != 0 ? -1.0F : 1.0F, sz = (index & 4) != 0 ? -1.0F : 1.0F;
    const float4v sign{sx, sy, sz, 0};
    if (sz > 0) return {sign, true, {float4v{0, 0, 1, 0}, float4v{1, 0, -sx, 0}, float4v{0, 1, -sy, 0}}};
    const float sxy = sx * sy;  // outside the diamond: the flip of eq. (4.17)
    return {sign, false, {float4v{sx, sy, 1, 0}, float4v{0, -sxy, -sx, 0}, float4v{-sxy, 0, -sy, 0}}};
}

inline float4v least(float4v a, float4v b) { return a < b ? a : b; }
inline float4v most(float4v a, float4v b) { return a > b ? a : b; }

int clip(const float4v* in, int count, int axis, float4v* out) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        const float4v p = in[i], q = in[i + 1 < count ? i + 1 : 0];
        if (p[axis] >= 0.0F) out[kept++] = p;
        if ((p[axis] < 0.0F) != (q[axis] < 0.0F)) out[kept++] = p + (q - p) * (p[axis] / (p[axis] - q[axis]));
    }
    return kept;
}

struct OctantBox {
    float x0, y0, x1, y1;
};

/// Bounds of |x| / W, |y| / W of the part of a triangle in the octant, its signs taken out; x0 > x1 if there is none.
OctantBox octant_box(float4v p0, float4v p1, float4v p2) {
    float4v a[7] = {p0, p1, p2}, b[7];
    int count = 3;
    const float4v low = least(least(p0, p1), p2);
    const float4v* corners = a;
    if (low[0] < 0.0F || low[1] < 0.0F || low[2] < 0.0F) {
        count = clip(a, count, 0, b);
        count = clip(b, count, 1, a);
        count = clip(a, count, 2, b);
        corners = b;
    }
    OctantBox box{1, 1, 0, 0};
    for (int i = 0; i < count; ++i) {
        const float4v p = corners[i];
        const float norm = std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]);
        if (norm < box_trusted_distance) return {0, 0, 1, 1};
        const float x = p[0] / norm, y = p[1] / norm;
        box = {std::min(box.x0, x), std::min(box.y0, y), std::max(box.x1, x), std::max(box.y1, y)};
    }
    return box;
}

void draw(const RasterTriangle& t, int triangle, const Octant& octant, OctantBox box, int n, RasterTarget& target) {
    const int half = n / 2;
    const auto size = static_cast<float>(half);
    if (!octant.front) box = {1 - box.y1, 1 - box.x1, 1 - box.y0, 1 - box.x0};
    const Range ku = raster_range(box.x0 * size, box.x1 * size, box_slack, half - 1);
    const Range kv = raster_range(box.y0 * size, box.y1 * size, box_slack, half - 1);
    const float du = 2.0F / static_cast<float>(n), u0 = 1.0F / static_cast<float>(n) - 1.0F;
    for (int k = kv.first; k <= kv.last; ++k) {
        const int k0 = octant.front ? ku.first : std::max(ku.first, half - k);
        const int k1 = octant.front ? std::min(ku.last, half - 1 - k) : ku.last;
        const int y = octant.sign[1] > 0 ? half + k : half - 1 - k;
        const int first = octant.sign[0] > 0 ? half + k0 : half - 1 - k1, last = octant.sign[0] > 0 ? half + k1 : half - 1 - k0;
        raster_row(t, triangle, u0, du, u0 + static_cast<float>(y) * du, first, last, y, target);
    }
}

void draw_triangle(const Triangle& triangle, int index, const float4& plane, float4v cop, const Octant* octants, int n,
                   RasterTarget& target) {
    const float ahead = plane_ahead(plane, cop);
    if (std::abs(ahead) < plane_tolerance) return;
    const float4v p0 = load_point(triangle.v0) - cop, p1 = load_point(triangle.v1) - cop, p2 = load_point(triangle.v2) - cop;
    for (int k = 0; k < 8; ++k) {
        const Octant& octant = octants[k];
        const float4v q0 = p0 * octant.sign, q1 = p1 * octant.sign, q2 = p2 * octant.sign;
        const float4v high = most(most(q0, q1), q2);
        if (high[0] < 0.0F || high[1] < 0.0F || high[2] < 0.0F) continue;
        const OctantBox box = octant_box(q0, q1, q2);
        if (box.x0 <= box.x1) draw(raster_setup(p0, p1, p2, plane, ahead, octant.frame), index, octant, box, n, target);
    }
}

}  // namespace

void rasterize_octahedral(const SceneView& scene, const float4* cops, int count, int n, Hit* hits) {
    Octant octants[8];
    for (int k = 0; k < 8; ++k) octants[k] = make_octant(k);
    const auto texels = static_cast<std::size_t>(PENCIL_TILE_TEXELS(n));
    parallel_blocks(count, 1, [&](int tile, int) {
        thread_local RasterTarget target(n, n);
        if (target.stride != n + lane_count) target = RasterTarget(n, n);
        target.clear();
        for (int i = 0; i < scene.triangle_count; ++i) {
            const Triangle& triangle = scene.triangles[i];
            draw_triangle(triangle, i, scene.planes[triangle.plane], load_point(cops[tile]), octants, n, target);
        }
        for (int y = 0; y < n; ++y) target.write_row(y, n, hits + static_cast<std::size_t>(tile) * texels + tile_index({0, y}, n));
    });
}

}  // namespace pencil::native
