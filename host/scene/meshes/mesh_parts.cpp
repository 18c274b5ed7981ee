#include "scene/meshes/mesh_parts.h"

#include <limits>

namespace pencil {
namespace {

constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();

/// `place` has a number for each vertex of the whole mesh, all `unused`, and is left so.
Mesh part_of(const Mesh& whole, const std::vector<std::uint32_t>& triangles, std::vector<std::uint32_t>& place) {
    Mesh part;
    part.smooth = whole.smooth;
    std::vector<std::uint32_t> used;
    for (const std::uint32_t t : triangles) {
        glm::uvec3 corners = whole.triangles[t];
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = corners[k];
            if (place[from] == unused) {
                place[from] = static_cast<std::uint32_t>(used.size());
                used.push_back(from);
            }
            corners[k] = place[from];
        }
        part.triangles.push_back(corners);
    }
    for (const std::uint32_t i : used) {
        part.positions.push_back(whole.positions[i]);
        if (!whole.normals.empty()) part.normals.push_back(whole.normals[i]);
        if (!whole.uvs.empty()) part.uvs.push_back(whole.uvs[i]);
        if (!whole.colours.empty()) part.colours.push_back(whole.colours[i]);
        place[i] = unused;
    }
    return part;
}

}  // namespace

std::vector<Mesh> parts_of(const Mesh& whole, const std::vector<std::uint32_t>& part, std::size_t parts) {
    std::vector<std::vector<std::uint32_t>> triangles(parts);
    for (std::size_t t = 0; t < part.size(); ++t) triangles[part[t]].push_back(static_cast<std::uint32_t>(t));
    std::vector<std::uint32_t> place(whole.positions.size(), unused);
    std::vector<Mesh> result;
    result.reserve(parts);
    for (const std::vector<std::uint32_t>& of_part : triangles) result.push_back(part_of(whole, of_part, place));
    return result;
}

}  // namespace pencil
