#include "scene/meshes/vertex_normals.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace pencil {
namespace {

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : glm::dvec3(0.0);
}

/// Of unit edges, so that neither the scene's unit nor a sliver's proportions matter.
glm::dvec3 face_normal(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return unit_or_zero(glm::cross(unit_or_zero(b - a), unit_or_zero(c - a)));
}

}  // namespace

std::vector<glm::dvec3> smooth_normals(const std::vector<glm::dvec3>& positions, const std::vector<glm::uvec3>& triangles) {
    std::vector<glm::dvec3> sums(positions.size(), glm::dvec3(0.0));
    for (const glm::uvec3& corners : triangles) {
        const glm::dvec3 p[3] = {positions[corners.x], positions[corners.y], positions[corners.z]};
        const glm::dvec3 normal = face_normal(p[0], p[1], p[2]);
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 to_next = unit_or_zero(p[(k + 1) % 3] - p[k]), to_last = unit_or_zero(p[(k + 2) % 3] - p[k]);
            sums[corners[k]] += std::acos(std::clamp(glm::dot(to_next, to_last), -1.0, 1.0)) * normal;
        }
    }
    for (glm::dvec3& sum : sums) sum = unit_or_zero(sum);
    return sums;
}

bool are_face_normals(const std::vector<glm::dvec3>& normals, const std::vector<glm::dvec3>& positions,
                      const std::vector<glm::uvec3>& triangles, double tolerance) {
    return std::all_of(
        triangles.begin(), triangles.end(),
        [&](const glm::uvec3& corners) {
            const glm::dvec3 normal = face_normal(positions[corners.x], positions[corners.y], positions[corners.z]);
            if (normal == glm::dvec3(0.0)) return true;
            for (int k = 0; k < 3; ++k)
                if (glm::length(normals[corners[k]] - normal) > tolerance) return false;
            return true;
        });
}

}  // namespace pencil
