// glTF's cameras and lights look along their own -z axis with +x to the right, those of a Scene along +z with +x to the left.
#pragma once

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>
#include <optional>

namespace pencil {

/// The frame of a Scene's sensor or spot at a node that has this place: without scale or shear, and never mirrored. None if the node has
/// no directions left.
inline std::optional<glm::dmat4> turned_frame(const glm::dmat4& to_world) {
    const glm::dvec3 z = -glm::dvec3(to_world[2]), y = glm::dvec3(to_world[1]), x = glm::cross(y, z);
    const double depth = glm::length(z), across = glm::length(x);
    if (!(depth > 0 && across > 0 && depth < 1e150 && across < 1e150)) return std::nullopt;
    glm::dmat4 frame(1.0);
    frame[0] = glm::dvec4(x / across, 0);
    frame[2] = glm::dvec4(z / depth, 0);
    frame[1] = glm::dvec4(glm::cross(glm::dvec3(frame[2]), glm::dvec3(frame[0])), 0);
    frame[3] = to_world[3];
    return frame;
}

/// Nothing of a scene may lie further from the origin.
inline bool is_in_range(const glm::dvec3& p) {
    constexpr double most = 1e18;
    return glm::all(glm::lessThanEqual(glm::abs(p), glm::dvec3(most)));
}

}  // namespace pencil
