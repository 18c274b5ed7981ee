// The geometry of a glTF mesh: each of its primitives, which have one material each, as a mesh in its own coordinates.
#pragma once

#include <string>

#include "scene/gltf/accessor.h"
#include "scene/meshes/mesh.h"

namespace pencil {

/// The triangles of a primitive with the texture coordinates of set `uv_set`; no triangles for one of points or lines. `label` names it in
/// messages. Morph targets are left out. Without normals its faces are flat, as glTF has it.
Mesh read_primitive(GltfFile& file, const tinygltf::Primitive& primitive, int uv_set, const std::string& label);

}  // namespace pencil
