// Maps of the unit square to what is sampled: triangles, directions.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace pencil {

/// Low-distortion map to a triangle's barycentric coordinates, uniform in area (Heitz 2019).
inline glm::dvec2 square_to_triangle(glm::dvec2 u) {
    if (u.y > u.x) {
        u.x *= 0.5;
        u.y -= u.x;
    } else {
        u.y *= 0.5;
        u.x -= u.y;
    }
    return u;
}

/// Uniform over the unit sphere.
inline glm::dvec3 square_to_sphere(const glm::dvec2& u) {
    const double z = 1.0 - 2.0 * u.x, r = std::sqrt(std::max(1.0 - z * z, 0.0)), angle = 2.0 * 3.14159265358979323846 * u.y;
    return {r * std::cos(angle), r * std::sin(angle), z};
}

/// About the unit vector `normal` with density cos / pi: the point of a sphere that touches the surface from above.
inline glm::dvec3 square_to_cosine(const glm::dvec2& u, const glm::dvec3& normal) {
    const glm::dvec3 sum = normal + square_to_sphere(u);
    const double length = glm::length(sum);
    return length > 1e-6 ? sum / length : normal;
}

}  // namespace pencil
