// Reads a scene file. Scene files are untrusted: every defect is a SceneError that names file, line and element.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "scene/scene.h"

namespace pencil {

struct LoadOptions {
    std::map<std::string, std::string> defines;  // override <default name= value=>, as Mitsuba's -D
};

/// Mitsuba XML (.xml), or a bare mesh (.obj, .ply) is refused with advice. The result has only finite numbers, valid indices, no
/// triangle of zero area (dropped, counted in warnings), and at least one sensor.
Scene load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

}  // namespace pencil
