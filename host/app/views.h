// Cameras from text, for `pencil walk`.
#pragma once

#include <filesystem>
#include <vector>

#include "scene/scene.h"

namespace pencil {

/// One camera for each line of the file that says more than a comment after #: the scene's own at another place. SceneError with file and line.
std::vector<PerspectiveSensor> read_views(const std::filesystem::path& file, const PerspectiveSensor& sensor);

}  // namespace pencil
