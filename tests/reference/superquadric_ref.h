// The superquadric family of thesis 4.3.1 from its look-up formula (4.4) alone: the inverse is found by bisection of the formula itself.
#pragma once

#include <limits>

#include "reference/map_ref.h"

namespace pencil::ref {

/// eq. (4.5), with the limit p = infinity, eq. (4.8).
inline double p_norm(const dvec3& v, double p) {
    const dvec3 a = glm::abs(v);
    if (std::isinf(p)) return std::max({a.x, a.y, a.z});
    return std::pow(std::pow(a.x, p) + std::pow(a.y, p) + std::pow(a.z, p), 1.0 / p);
}

/// Denominator of eq. (4.4): |v_z| + d.
inline double superquadric_depth(const dvec3& v, double p, bool cone) { return std::abs(v.z) + p_norm(cone ? dvec3(v.x, v.y, 0.0) : v, p); }

/// z >= 0 for which (u, v, z) has depth 1. The depth grows with z; where it is more than 1 already at z = 0, outside the rim, the base
/// is continued by point reflection about it: r becomes 2 - r and z changes sign.
inline double superquadric_height(const dvec2& uv, double p, bool cone) {
    const double r = p_norm(dvec3(uv, 0.0), p);
    if (r >= 2.0) return -superquadric_height({0, 0}, p, cone);
    if (r > 1.0) return -superquadric_height(uv * ((2.0 - r) / r), p, cone);
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 60; ++i) {
        const double z = 0.5 * (low + high);
        (superquadric_depth(dvec3(uv, z), p, cone) < 1.0 ? low : high) = z;
    }
    return 0.5 * (low + high);
}

inline Map superquadric_map(double p, bool cone) {
    const auto to_direction = [=](int tile, const dvec2& uv) { return mirrored(dvec3(uv, superquadric_height(uv, p, cone)), tile); };
    const std::string exponent = std::isinf(p) ? "infinite" : std::to_string(p).substr(0, 3);
    return {std::string("superquadric ") + (cone ? "cone " : "paraboloid ") + exponent,
            2,
            [=](const dvec3& v) {
                return MapPoint{dual_tile(v), dvec2(v) / superquadric_depth(v, p, cone)};
            },
            to_direction,
            [p](const dvec2& uv) { return p_norm(dvec3(uv, 0.0), p) <= 1.0; },
            [to_direction](int tile, int x, int y, int n) { return to_direction(tile, texel_centre(x, y, n)); },
            false};
}

}  // namespace pencil::ref
