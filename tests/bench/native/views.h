// What the native loops read: plain pointers to host copies of what the kernels read. Layouts are those of kernels/shared.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "shared/atlas.h"
#include "shared/camera.h"
#include "shared/geometry.h"
#include "shared/light.h"
#include "shared/material.h"
#include "shared/surfel.h"
#include "shared/types.h"

namespace pencil::native {

struct SceneView {
    const Triangle* triangles = nullptr;
    int triangle_count = 0;
    const float4* planes = nullptr;
    const Material* materials = nullptr;
};

/// Geometry maps; `cells` and `groups` are those of native::fold_hits.
struct MapsView {
    const float4* cops = nullptr;
    int count = 0, n = 0;
    const Hit* hits = nullptr;
    const glm::ivec2* cells = nullptr;
    const glm::ivec4* groups = nullptr;

    std::size_t tile_texels() const { return static_cast<std::size_t>(PENCIL_TILE_TEXELS(n)); }
};

struct SurfelsView {
    const float* data = nullptr;
    std::size_t capacity = 0;
    int count = 0;

    const float* field(int f) const { return data + static_cast<std::size_t>(f) * capacity; }
};

/// Rgb per surfel: [3][capacity].
struct RgbView {
    float* data = nullptr;
    std::size_t capacity = 0;

    float* channel(int c) const { return data + static_cast<std::size_t>(c) * capacity; }
};

}  // namespace pencil::native
