// The nodes of a glTF scene with their places in the world.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>

#include "scene/gltf/gltf_file.h"

namespace pencil {

/// What is at a node: its index and its own coordinates in the world.
using NodeVisitor = std::function<void(std::size_t node, const glm::dmat4& to_world)>;

/// Visits the nodes of the file's default scene, or of its first, or all if it has no scene: parents first, children in the file's order.
/// A node below several others is visited at each; SceneError for one within itself.
void visit_nodes(GltfFile& file, const NodeVisitor& visit);

}  // namespace pencil
