// Vertices that are NaN or infinite, as scanners and damaged exports have them.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/meshes/mesh.h"

namespace pencil {

bool is_finite(const glm::dvec3& v);

/// Takes the triangles out that use these vertices, which are given in ascending order; a note says so.
void leave_out_nowhere(const std::vector<std::uint32_t>& vertices, Mesh& mesh);

}  // namespace pencil
