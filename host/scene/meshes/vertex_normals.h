// Vertex normals of meshes that come without.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace pencil {

/// Unit normals at the positions: the normals of the triangles around, weighted by their angles there (Thuermer and Wuethrich, Computing
/// Vertex Normals from Polygonal Facets, Journal of Graphics Tools 3(1), 1998). Zero where no triangle gives a direction. Counter-clockwise
/// triangles, any unit.
std::vector<glm::dvec3> smooth_normals(const std::vector<glm::dvec3>& positions, const std::vector<glm::uvec3>& triangles);

/// True if the normals of every triangle's corners are the triangle's own within `tolerance` (length of the difference).
bool are_face_normals(const std::vector<glm::dvec3>& normals, const std::vector<glm::dvec3>& positions,
                      const std::vector<glm::uvec3>& triangles, double tolerance);

}  // namespace pencil
