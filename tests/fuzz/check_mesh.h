// What every reader promises of a mesh that it returns.
#pragma once

#include <cmath>
#include <cstdlib>

#include "scene/meshes/mesh.h"
#include "util/error.h"

namespace pencil::fuzz {

/// Ends the process, which the fuzzer reports with the input that led here. assert() would be compiled out.
inline void require(bool holds) {
    if (!holds) std::abort();
}

inline bool is_finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

inline void check_mesh(const Mesh& mesh) {
    require(mesh.normals.empty() || mesh.normals.size() == mesh.positions.size());
    require(mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size());
    for (const glm::dvec3& position : mesh.positions) require(is_finite(position));
    for (const glm::dvec3& normal : mesh.normals) require(is_finite(normal));
    for (const glm::uvec3& corners : mesh.triangles)
        for (int k = 0; k < 3; ++k) require(corners[k] < mesh.positions.size());
}

/// Calls `read` on the input; an error of the scene's kind is an answer, any other exception ends the process.
template <class Read>
void accept_scene_errors(Read read) {
    try {
        read();
    } catch (const Error& error) {
        require(error.code() == ExitCode::scene);
    }
}

}  // namespace pencil::fuzz
