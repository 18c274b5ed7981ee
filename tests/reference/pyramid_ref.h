// Dual pyramid map (thesis 4.3.1) face by face: each is the linear projection (4.14) with the parameters of table 4.1.
#pragma once

#include "reference/map_ref.h"

namespace pencil::ref {

/// Rows of table 4.1: the face lies towards (q_x, q_y), where q_x v_x + q_y v_y is the larger of |v_x| and |v_y|. DEVIATION: the table's B
/// is (0, -1) and its conditions are of a v axis that points down; here v points as v_y.
inline dvec2 pyramid_face(const dvec2& v) {
    for (const dvec2 q : {dvec2(1, 0), dvec2(-1, 0), dvec2(0, 1), dvec2(0, -1)})
        if (glm::dot(q, v) >= std::max(std::abs(v.x), std::abs(v.y))) return q;
    return {0, 0};
}

inline dvec3 pyramid_to_direction(int tile, const dvec2& uv) {
    const double h = tile == 0 ? 1.0 : -1.0;
    return {uv, h * (1.0 - glm::dot(pyramid_face(uv), uv))};  // w = q_x v_x + q_y v_y + h v_z = 1
}

/// Texel that a gutter texel repeats: the edge texel at the same place of the other hemisphere; a corner crosses twice.
inline dvec3 pyramid_stored_direction(int tile, int x, int y, int n) {
    if (x < 0 || x >= n) return pyramid_stored_direction(1 - tile, x < 0 ? 0 : n - 1, y, n);
    if (y < 0 || y >= n) return pyramid_stored_direction(1 - tile, x, y < 0 ? 0 : n - 1, n);
    return pyramid_to_direction(tile, texel_centre(x, y, n));
}

inline Map pyramid_map() {
    return {"pyramid",
            2,
            [](const dvec3& v) {
                const double h = dual_tile(v) == 0 ? 1.0 : -1.0, w = glm::dot(pyramid_face(dvec2(v)), dvec2(v)) + h * v.z;
                return MapPoint{dual_tile(v), dvec2(v) / w};
            },
            pyramid_to_direction,
            [](const dvec2&) { return true; },
            pyramid_stored_direction,
            true};
}

}  // namespace pencil::ref
