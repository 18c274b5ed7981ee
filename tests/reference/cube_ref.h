// Cube map: central projection onto the six faces of [-1, 1]^3, each with its own axes. Thesis 4.3.
#pragma once

#include "reference/map_ref.h"

namespace pencil::ref {

struct CubeFace {
    dvec3 towards, u, v;
};
inline const CubeFace& cube_face(int tile) {
    static const CubeFace faces[6] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                      {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}, {{0, -1, 0}, {0, 0, 1}, {1, 0, 0}},
                                      {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}};
    return faces[tile];
}

inline dvec3 cube_to_direction(int tile, const dvec2& uv) {
    const CubeFace& f = cube_face(tile);
    return f.towards + uv.x * f.u + uv.y * f.v;
}

inline MapPoint cube_to_point(const dvec3& v) {
    int best = 0;
    for (int tile = 1; tile < 6; ++tile)
        if (glm::dot(cube_face(tile).towards, v) > glm::dot(cube_face(best).towards, v)) best = tile;
    const CubeFace& f = cube_face(best);
    const double major = glm::dot(f.towards, v);
    return {best, {glm::dot(f.u, v) / major, glm::dot(f.v, v) / major}};
}

/// A gutter texel repeats the texel that shares its edge: it is found by walking from the edge half a texel into the next face. The gutter
/// texels at a corner hold the corner's direction.
inline dvec3 cube_stored_direction(int tile, int x, int y, int n) {
    const dvec2 uv = texel_centre(x, y, n), edge = glm::clamp(uv, -1.0, 1.0);
    const dvec3 on_edge = cube_to_direction(tile, edge);
    const bool corner = (x < 0 || x >= n) && (y < 0 || y >= n);
    return uv == edge || corner ? on_edge : on_edge - cube_face(tile).towards / static_cast<double>(n);
}

inline Map cube_map() {
    return {"cube", 6, cube_to_point, cube_to_direction, [](const dvec2&) { return true; }, cube_stored_direction, true};
}

}  // namespace pencil::ref
