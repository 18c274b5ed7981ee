// Wavefront OBJ: v, vn, vt and f. Groups, materials and all other statements are skipped: the scene file says what a shape is made of.
#pragma once

#include <string>
#include <string_view>

#include "scene/meshes/mesh.h"

namespace pencil {

/// `name` is the file's name for messages. Polygons become fans from their first corner. Normals and texture coordinates only where a face
/// names them.
Mesh read_obj(std::string_view text, const std::string& name);

}  // namespace pencil
