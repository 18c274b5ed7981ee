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
    std::string name;                                // as its users call it
    bool (*recognises)(std::string_view head) = {};  // the first head_bytes of a file, or all of a shorter one
    Scene (*read)(const std::filesystem::path& file, const LoadOptions& options) = {};  // null: known, but not read
    std::string advice = {};                                                            // where `read` is null: what to do instead
    std::string extension = {};  // where `read` is given: of files whose content nothing recognises, so that the reader says what is wrong
};

/// All formats. The first that recognises a file is the one.
const std::vector<SceneFormat>& scene_formats();

}  // namespace pencil
