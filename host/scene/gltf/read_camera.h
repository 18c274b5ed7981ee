// Cameras of a glTF file.
#pragma once

#include <glm/mat4x4.hpp>

#include "scene/gltf/gltf_file.h"
#include "scene/scene.h"

namespace pencil {

/// Camera `index` at a node. The film's longer side has the default width; its proportions are the camera's, or else the default ones.
/// Nothing is cut off far away: the far planes of files serve depth buffers.
PerspectiveSensor read_camera(GltfFile& file, int index, const glm::dmat4& to_world, const std::string& user);

}  // namespace pencil
