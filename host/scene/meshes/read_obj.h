// Wavefront OBJ: v, vn, vt, f, usemtl, mtllib, and s for files opened as scenes. All other statements are skipped. Text is UTF-8, or UTF-16 with
// its mark.
#pragma once

#include <string>
#include <string_view>

#include "scene/meshes/mesh.h"

namespace pencil {

/// The mesh of a file that a scene names: the scene says what it is made of. `name` is the file's name for messages. Concave polygons are
/// cut as they are. Normals and texture coordinates only where a face names them; normals that are no numbers are left out, with a note.
Mesh read_obj(std::string_view text, const std::string& name);

/// The file as its own scene. Where a face names no normals it is flat, or smooth within its smoothing group. Vertices have their colours.
Mesh read_obj_file(std::string_view text, const std::string& name);

}  // namespace pencil
