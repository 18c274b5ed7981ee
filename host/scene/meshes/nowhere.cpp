#include "scene/meshes/nowhere.h"

#include <algorithm>
#include <cmath>

namespace pencil {

bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void leave_out_nowhere(const std::vector<std::uint32_t>& vertices, Mesh& mesh) {
    if (vertices.empty()) return;
    const auto is_nowhere = [&](std::uint32_t corner) { return std::binary_search(vertices.begin(), vertices.end(), corner); };
    const std::size_t before = mesh.triangles.size();
    mesh.triangles.erase(std::remove_if(mesh.triangles.begin(), mesh.triangles.end(),
                                        [&](const glm::uvec3& t) { return is_nowhere(t.x) || is_nowhere(t.y) || is_nowhere(t.z); }),
                         mesh.triangles.end());
    mesh.notes.push_back(std::to_string(vertices.size()) + " vertices are nowhere (NaN or infinite); the " +
                         std::to_string(before - mesh.triangles.size()) + " triangles that use them are left out");
}

}  // namespace pencil
