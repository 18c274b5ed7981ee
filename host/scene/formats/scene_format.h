// A format of scene files: how to know one, and what reads it.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/load_options.h"
#include "scene/scene.h"

namespace pencil {

/// Bytes of a file that tell its format.
constexpr std::size_t head_bytes = 4096;

struct SceneFormat {
    std::string name;  // as its users call it
    /// `head`: the first head_bytes of a file, or all of a shorter one. Any bytes.
    bool (*recognises)(std::string_view head) = nullptr;
    /// Null for a format that is known, but not read.
    Scene (*read)(const std::filesystem::path& file, const LoadOptions& options) = nullptr;
    std::string advice = {};     // what to do instead, where `read` is null
    std::string extension = {};  // files of this name go to `read` even if nothing recognises them: it says what is wrong
};

/// All formats. The first that recognises a file is the one.
const std::vector<SceneFormat>& scene_formats();

}  // namespace pencil
