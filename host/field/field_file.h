// Fields of pencils as OpenEXR files: an atlas of maps, whose header names the centres.
#pragma once

#include <filesystem>
#include <string>

#include "options/pencil_field.h"

namespace pencil {

/// `from`: what made the light, for the header. OutputError.
void write_field(const std::filesystem::path& path, const PencilField& field, const std::string& from);

/// SceneError naming the file if it is no field, damaged, or larger than fields may be.
PencilField read_field(const std::filesystem::path& path);

}  // namespace pencil
