// Irradiance from uniform polygons in closed form (Lambert 1760), the ground truth of direct light and of the lit-wall box.
#pragma once

#include <vector>

#include "reference/octahedral_ref.h"

namespace pencil::ref {

/// The part of a polygon above the horizon of x: dot(normal, p - x) >= 0. Corners are returned relative to x.
inline std::vector<dvec3> clip_to_horizon(const std::vector<dvec3>& polygon, const dvec3& x, const dvec3& normal) {
    std::vector<dvec3> out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec3 a = polygon[i] - x, b = polygon[(i + 1) % polygon.size()] - x;
        const double da = glm::dot(normal, a), db = glm::dot(normal, b);
        if (da >= 0.0) out.push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) out.push_back(a + (b - a) * (da / (da - db)));
    }
    return out;
}

/// Irradiance at x per unit radiance: E/L = 1/2 |sum over edges of angle * dot(unit normal of the edge's cone, normal)|. The polygon is
/// planar and convex and seen from either side; x must not lie on it.
inline double polygon_irradiance(const std::vector<dvec3>& polygon, const dvec3& x, const dvec3& normal) {
    const std::vector<dvec3> p = clip_to_horizon(polygon, x, normal);
    double sum = 0.0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const dvec3 a = glm::normalize(p[i]), b = glm::normalize(p[(i + 1) % p.size()]);
        const dvec3 axis = glm::cross(a, b);
        const double sine = glm::length(axis);
        if (sine > 0.0) sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(axis / sine, normal);
    }
    return 0.5 * std::abs(sum);
}

/// Configuration factor from a small surface to a parallel rectangle a x b, one corner of which is straight above at height c.
inline double parallel_corner_factor(double a, double b, double c) {
    const double x = a / c, y = b / c, p = std::sqrt(1.0 + x * x), q = std::sqrt(1.0 + y * y);
    return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2.0 * pi);
}

/// Configuration factor from a small surface to a perpendicular rectangle that stands on its plane, `width` along the plane from the foot
/// point, `height` upright, at distance c.
inline double perpendicular_corner_factor(double width, double height, double c) {
    const double root = std::sqrt(height * height + c * c);
    return (std::atan(width / c) - c / root * std::atan(width / root)) / (2.0 * pi);
}

/// Irradiance per unit radiance on the floor (y = 0) of the unit box from the wall x = 0.
inline double lit_wall_irradiance(double x, double z) {
    return pi * (perpendicular_corner_factor(z, 1.0, x) + perpendicular_corner_factor(1.0 - z, 1.0, x));
}

}  // namespace pencil::ref
