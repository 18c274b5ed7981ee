// Reads a scene file of any known format. Scene files are untrusted: every defect is a SceneError that names file, line and element.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/formats/scene_format.h"
#include "scene/load_options.h"
#include "scene/scene.h"

namespace pencil {

/// The format is told by what the file begins with. The result has only finite numbers, valid indices, no triangle of zero area (dropped,
/// counted in warnings), and a sensor. SceneError for a file that is no scene or whose format has no reader; it says what to try.
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

/// The same with `formats` instead of scene_formats().
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options, const std::vector<SceneFormat>& formats);

}  // namespace pencil
