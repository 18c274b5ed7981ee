// Reads Mitsuba's scene files (XML, versions 0.5 to 3).
#pragma once

#include <filesystem>

#include "scene/load_options.h"
#include "scene/scene.h"

namespace pencil {

/// SceneError for every defect, with file, line and element.
Scene read_mitsuba(const std::filesystem::path& file, const LoadOptions& options);

}  // namespace pencil
