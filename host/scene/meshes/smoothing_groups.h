// Normals by smoothing groups: faces of one group share a normal at each position, others are flat.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "scene/meshes/vertex_normals.h"

namespace pencil {

class SmoothingGroups {
public:
    /// The next vertex of the mesh: where it is, and in which group; group 0 is flat, or has a normal of its own.
    void add_vertex(const glm::dvec3& position, std::size_t position_number, std::size_t group) {
        points_.push_back(none);
        if (group == 0) return;
        const auto [place, is_new] = point_of_.emplace(std::pair(position_number, group), static_cast<std::uint32_t>(positions_.size()));
        if (is_new) positions_.push_back(position);
        points_.back() = place->second;
    }

    /// Sets the normals of vertices in groups. False if there are none.
    bool assign(const std::vector<glm::uvec3>& triangles, std::vector<glm::dvec3>& normals) const {
        if (positions_.empty()) return false;
        std::vector<glm::uvec3> smooth;
        for (const glm::uvec3& t : triangles)
            if (points_[t.x] != none && points_[t.y] != none && points_[t.z] != none)
                smooth.emplace_back(points_[t.x], points_[t.y], points_[t.z]);
        const std::vector<glm::dvec3> computed = smooth_normals(positions_, smooth);
        for (std::size_t i = 0; i < points_.size(); ++i)
            if (points_[i] != none) normals[i] = computed[points_[i]];
        return true;
    }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::map<std::pair<std::size_t, std::size_t>, std::uint32_t> point_of_;  // by position and group
    std::vector<glm::dvec3> positions_;                                      // of points
    std::vector<std::uint32_t> points_;                                      // of vertices
};

}  // namespace pencil
