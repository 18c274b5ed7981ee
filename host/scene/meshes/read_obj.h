// Wavefront OBJ: v, vn, vt, f, and for files opened as scenes usemtl, mtllib and s. All other statements are skipped.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/meshes/mesh.h"

namespace pencil {

/// The mesh of a file that a scene names: the scene says what it is made of. `name` is the file's name for messages. Concave polygons are
/// cut as they are. Normals and texture coordinates only where a face names them; normals that are no numbers are left out, with a note.
Mesh read_obj(std::string_view text, const std::string& name);

/// The file as its own scene. Where a face names no normals it is flat, or smooth within its smoothing group.
struct ObjFile {
    Mesh mesh;
    std::vector<std::uint32_t> material;  // of each triangle: index into materials
    std::vector<std::string> materials;   // as usemtl names them, "" before the first
    std::vector<std::string> libraries;   // operands of mtllib
};
ObjFile read_obj_file(std::string_view text, const std::string& name);

}  // namespace pencil
