// glTF 2.0, as JSON with files beside it (.gltf) or in one binary (.glb). docs/formats-gltf.md says what is read of it and how.
#pragma once

#include <filesystem>
#include <string_view>

#include "scene/load_options.h"
#include "scene/scene.h"

namespace pencil {

/// `head`: the first kilobytes of a file.
bool is_gltf(std::string_view head);

/// A scene without camera is framed, one without light gets a sky; both are told in its warnings.
Scene read_gltf(const std::filesystem::path& file, const LoadOptions& options);

}  // namespace pencil
