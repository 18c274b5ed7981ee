// Opening the files that a scene names: only regular files, only up to a size. Where they may lie: file_search.h.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pencil {

constexpr std::uintmax_t max_xml_bytes = std::uintmax_t{16} << 20;  // hand-written or exported scenes; meshes are files of their own
constexpr std::uintmax_t max_mesh_bytes = std::uintmax_t{2} << 30;

/// The path as given, safe to print.
std::string shown(const std::filesystem::path& file);

/// `where` is blamed: the scene line that names the file, or the file itself.
std::string read_regular_file(const std::filesystem::path& file, std::uintmax_t max_bytes, const std::string& where);

/// The first `bytes` of a regular file of any size, or all of it if it is shorter.
std::string read_head(const std::filesystem::path& file, std::size_t bytes, const std::string& where);

}  // namespace pencil
