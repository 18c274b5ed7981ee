// Core of the native rasterisers: edge functions and disparity as affine functions of the texel coordinates (kernels/lib/raster.cl), drawn
// into separate planes of disparities and triangles, so that a row is a few vector operations without branches.
#pragma once

#include <cmath>
#include <vector>

#include "bench/native/triangle.h"

namespace pencil::native {

struct RasterFrame {
    float4v origin, du, dv;
};

struct RasterTriangle {
    float4v a, b, c;  // edge functions (0, 1, 2) and disparity (3) are a u + b v + c
};

inline RasterTriangle raster_setup(float4v p0, float4v p1, float4v p2, const float4& plane, float ahead, const RasterFrame& frame) {
    const float side = ahead > 0.0F ? 1.0F : -1.0F;
    const float4v e0 = edge_normal(p0, p1) * side, e1 = edge_normal(p1, p2) * side, e2 = edge_normal(p2, p0) * side;
    const float4v w = load_point(plane) / ahead;
    const auto along = [&](float4v d) { return float4v{dot3(e0, d), dot3(e1, d), dot3(e2, d), dot3(w, d)}; };
    return {along(frame.du), along(frame.dv), along(frame.origin)};
}

/// Nearest so far; rows are padded by a vector.
struct RasterTarget {
    std::vector<float> disparity;
    std::vector<int> triangle;
    int stride = 0;
    RasterTarget(int width, int height)
        : disparity(static_cast<std::size_t>(width + lane_count) * static_cast<std::size_t>(height)),
          triangle(disparity.size()),
          stride(width + lane_count) {}
    void clear() {
        std::fill(disparity.begin(), disparity.end(), 0.0F);
        std::fill(triangle.begin(), triangle.end(), -1);
    }
    void write_row(int y, int width, Hit* row) const {
        const int* triangles = triangle.data() + y * stride;
        const float* disparities = disparity.data() + y * stride;
        for (int x = 0; x < width; ++x) row[x] = {triangles[x], disparities[x]};
    }
};

/// Draws texels first..last of row y; u of texel x is u0 + x du.
inline void raster_row(const RasterTriangle& t, int triangle, float u0, float du, float v, int first, int last, int y,
                       RasterTarget& target) {
    const float4v base = t.b * v + t.c;
    const vfloat lanes = __builtin_convertvector(lane_numbers(), vfloat);
    float* disparity = target.disparity.data() + y * target.stride;
    int* triangles = target.triangle.data() + y * target.stride;
    for (int x = first; x <= last; x += lane_count) {
        const vfloat u = (lanes + static_cast<float>(x)) * du + u0;
        const vfloat inside = minimum(minimum(t.a[0] * u + base[0], t.a[1] * u + base[1]), t.a[2] * u + base[2]);
        const vfloat w = t.a[3] * u + base[3], before = load<vfloat>(disparity + x);
        const vint nearer = (inside >= 0.0F) & (w > before) & (lane_numbers() <= last - x);
        store(nearer ? w : before, disparity + x);
        store(nearer ? broadcast(triangle) : load<vint>(triangles + x), triangles + x);
    }
}

struct Range {
    int first, last;
};

/// Texels whose centres lie in [low, high], widened by `slack`: it only bounds the search.
inline Range raster_range(float low, float high, float slack, int last) {
    return {std::max(static_cast<int>(std::ceil(low - 0.5F - slack)), 0),
            std::min(static_cast<int>(std::floor(high - 0.5F + slack)), last)};
}

}  // namespace pencil::native
