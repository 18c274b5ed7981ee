// Lights of KHR_lights_punctual. Their candela and lux become watts by 683 lumen each, the convention in which Blender writes and reads
// them.
#pragma once

#include <glm/mat4x4.hpp>

#include "scene/gltf/gltf_file.h"
#include "scene/scene.h"

namespace pencil {

/// Appends light `index` to the scene, at a node and along its -z axis. `user` is the node.
void read_light(GltfFile& file, int index, const glm::dmat4& to_world, const std::string& user, Scene& scene);

}  // namespace pencil
