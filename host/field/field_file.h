// Fields of pencils as OpenEXR files: an atlas of maps, whose header names the centres.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "options/pencil_field.h"

namespace pencil {

/// Bytes of the light of a field.
std::uint64_t field_bytes(int pencils, int map);

/// UsageError if such a field would make a larger file than read_field accepts.
void check_field_size(int pencils, int map);

/// `from`: what made the light, for the header. OutputError.
void write_field(const std::filesystem::path& path, const PencilField& field, const std::string& from);

/// SceneError naming the file if it is no field, damaged, or larger than fields may be.
PencilField read_field(const std::filesystem::path& path);

}  // namespace pencil
