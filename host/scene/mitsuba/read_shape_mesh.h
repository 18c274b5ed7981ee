// The geometry of Mitsuba's shapes, before it is placed.
#pragma once

#include "scene/meshes/mesh.h"
#include "scene/mitsuba/properties.h"

namespace pencil {

/// False for plugins that are left out.
bool is_known_shape(const std::string& kind);
/// Of a known kind but "sphere", of which all have the same.
Mesh read_shape_mesh(Properties& p, const std::string& kind);
/// "to_world", and before it what the shape has of its own: centre and radius, ends.
glm::dmat4 shape_to_world(Properties& p, const std::string& kind);

}  // namespace pencil
