// Files of meshes opened as scenes: framed, lit by a sky if nothing in them emits, and of the materials that they name.
#pragma once

#include <filesystem>
#include <string_view>

#include "scene/load_options.h"
#include "scene/scene.h"

namespace pencil {

/// By the first kilobytes of a file.
bool is_obj(std::string_view head);
bool is_ply(std::string_view head);

/// Faces of one material are one shape. Libraries of materials that cannot be read are left out with a warning.
Scene read_obj_scene(const std::filesystem::path& file, const LoadOptions& options);

/// One shape, of the colours of its vertices or else grey.
Scene read_ply_scene(const std::filesystem::path& file, const LoadOptions& options);

}  // namespace pencil
