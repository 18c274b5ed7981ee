// What a scene is made of, as `pencil info` lists it on the standard output.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "scene/scene.h"

namespace pencil {

/// "(1, 2, 3)"
std::string vector_text(const glm::dvec3& v);

void list_lights(const Scene& scene);
void list_materials(const Scene& scene);
void list_textures(const Scene& scene);

}  // namespace pencil
