// A mesh of several materials, taken apart.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/meshes/mesh.h"

namespace pencil {

/// For each part the triangles that are of it, with the vertices that they use. `part` has a number below `parts` for each triangle. What the
/// file says of itself (notes, materials, libraries) stays with the whole.
std::vector<Mesh> parts_of(const Mesh& whole, const std::vector<std::uint32_t>& part, std::size_t parts);

}  // namespace pencil
