// PLY in its three encodings: the positions, normals, texture coordinates and colours of vertices, and faces or strips of triangles; all
// other elements and properties are skipped.
#pragma once

#include <string>
#include <string_view>

#include "scene/meshes/mesh.h"

namespace pencil {

/// `name` is the file's name for messages. Polygons become fans from their first corner.
Mesh read_ply(std::string_view bytes, const std::string& name);

}  // namespace pencil
