// Dual paraboloid map (thesis 4.3, eq. (4.3)) by its geometry: an orthographic view along z of a mirror that reflects z to the direction.
#pragma once

#include "reference/map_ref.h"

namespace pencil::ref {

inline Map paraboloid_map() {
    const auto to_direction = [](int tile, const dvec2& uv) {
        const dvec3 normal = glm::normalize(dvec3(uv, 1.0)), axis(0, 0, 1);  // the mirror's normal halves the angle between z and d
        return mirrored(2.0 * glm::dot(axis, normal) * normal - axis, tile);
    };
    return {"paraboloid",
            2,
            [](const dvec3& v) {
                const dvec3 half = mirrored(glm::normalize(v), dual_tile(v)) + dvec3(0, 0, 1);
                return MapPoint{dual_tile(v), dvec2(half) / half.z};
            },
            to_direction,
            [](const dvec2& uv) { return glm::length(uv) <= 1.0; },
            [to_direction](int tile, int x, int y, int n) { return to_direction(tile, texel_centre(x, y, n)); },
            false};
}

}  // namespace pencil::ref
