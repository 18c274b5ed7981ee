// Octahedral map, thesis eq. (4.25), scalar and for vectors of directions.
#pragma once

#include <cmath>
#include <cstddef>

#include "bench/native/simd.h"
#include "shared/atlas.h"

namespace pencil::native {

struct Texel {
    int x, y;
};

inline float4v to_direction(float u, float v) {
    const float z = 1.0F - std::abs(u) - std::abs(v);
    const float fold = std::fmax(-z, 0.0F);
    return float4v{u - std::copysign(fold, u), v - std::copysign(fold, v), z, 0.0F};
}

inline float4v texel_direction(Texel t, int n) {
    return to_direction(static_cast<float>(2 * t.x + 1) / static_cast<float>(n) - 1.0F,
                        static_cast<float>(2 * t.y + 1) / static_cast<float>(n) - 1.0F);
}

/// Coordinates up to one texel outside the tile back into it, across the edges of the octahedron.
inline Texel fold_texel(Texel t, int n) {
    if (t.x < 0 || t.x >= n) t = {t.x < 0 ? -1 - t.x : 2 * n - 1 - t.x, n - 1 - t.y};
    if (t.y < 0 || t.y >= n) t = {n - 1 - t.x, t.y < 0 ? -1 - t.y : 2 * n - 1 - t.y};
    return t;
}

/// Index of a texel within its tile.
inline int tile_index(Texel t, int n) { return (t.y + PENCIL_GUTTER) * PENCIL_TILE_STRIDE(n) + t.x + PENCIL_GUTTER; }

/// Texel of surfel i of a tile: blocks of 8 x 8, patches of 4 x 2.
inline Texel surfel_texel(int i, int n) {
    const int block = i / 64, patch = i % 64 / 8, lane = i % 8;
    return {8 * (block % (n / 8)) + patch % 2 * 4 + lane % 4, 8 * (block / (n / 8)) + patch / 2 * 2 + lane / 4};
}

/// Texel whose centre lies in the opposite direction.
inline Texel antipode(Texel t, int n) {
    const int half = n / 2;
    const int kx = t.x >= half ? t.x - half : half - 1 - t.x, ky = t.y >= half ? t.y - half : half - 1 - t.y;
    const int ax = half - 1 - ky, ay = half - 1 - kx;
    return {t.x >= half ? half - 1 - ax : half + ax, t.y >= half ? half - 1 - ay : half + ay};
}

/// Where directions fall in a tile: first texel of the 2x2 footprint (counted from the gutter) and bilinear weights.
struct Footprints {
    vint x, y, index;
    vfloat fx, fy;
};

inline Footprints footprints(vfloat vx, vfloat vy, vfloat vz, int n) {
    const vfloat norm = maximum(absolute(vx) + absolute(vy) + absolute(vz), broadcast(1e-30F));
    const vfloat scale = (0.5F * static_cast<float>(n)) / norm;
    const vfloat fold = maximum(-vz, broadcast(0.0F));
    const float centre = 0.5F * static_cast<float>(n) + 0.5F;
    const vfloat x = (vx + copy_sign(fold, vx)) * scale + centre, y = (vy + copy_sign(fold, vy)) * scale + centre;
    Footprints f;
    f.x = __builtin_convertvector(x, vint);
    f.y = __builtin_convertvector(y, vint);
    f.index = f.y * PENCIL_TILE_STRIDE(n) + f.x;
    f.fx = x - __builtin_convertvector(f.x, vfloat);
    f.fy = y - __builtin_convertvector(f.y, vfloat);
    return f;
}

/// Bilinear texel; `t` is the footprint's first. Two texels of a row are loaded at once.
inline float4v fetch(const glm::vec4* t, int stride, float fx, float fy) {
    const float8v upper = load<float8v>(t), lower = load<float8v>(t + stride);
    const float8v row = upper + fy * (lower - upper);
    const float4v left = __builtin_shufflevector(row, row, 0, 1, 2, 3), right = __builtin_shufflevector(row, row, 4, 5, 6, 7);
    return left + fx * (right - left);
}

}  // namespace pencil::native
