// Polygons as triangles.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace pencil {

/// Appends the triangles of a polygon, given by the indices of its corners into `positions`, in its own orientation. Convex ones, and those
/// that are not flat or simple, become fans from their first corner; concave ones are cut right (by ears), as far as they have no more than
/// some thousand corners.
void triangulate(const std::vector<std::uint32_t>& polygon, const std::vector<glm::dvec3>& positions, std::vector<glm::uvec3>& triangles);

}  // namespace pencil
