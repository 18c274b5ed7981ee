// A scene may come from anywhere, so it must not make the program read devices that never end.
#include "scene/scene_file.h"

#include <algorithm>
#include <fstream>

#include "scene/text.h"
#include "util/error.h"

namespace pencil {

namespace fs = std::filesystem;

std::string shown(const fs::path& file) { return escaped(file.string(), 200); }

namespace {

/// Of a regular file; anything else is refused before it is opened.
std::uintmax_t regular_size(const fs::path& file, const std::string& where) {
    const std::string name = '"' + shown(file) + '"';
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (status.type() == fs::file_type::not_found) throw SceneError(where, name + " does not exist");
    if (error) throw SceneError(where, "cannot open " + name + ": " + error.message());
    if (status.type() == fs::file_type::directory) throw SceneError(where, name + " is a directory, not a file");
    if (status.type() != fs::file_type::regular) throw SceneError(where, name + " is not a regular file");
    const std::uintmax_t size = fs::file_size(file, error);
    if (error) throw SceneError(where, "cannot read " + name + ": " + error.message());
    return size;
}

std::string read_bytes(const fs::path& file, std::uintmax_t bytes, const std::string& where) {
    const std::string name = '"' + shown(file) + '"';
    std::ifstream stream(file, std::ios::binary);
    std::string content(static_cast<std::size_t>(bytes), '\0');
    if (!stream) throw SceneError(where, "cannot open " + name + ": no permission to read it?");
    if (!stream.read(content.data(), static_cast<std::streamsize>(bytes))) throw SceneError(where, "cannot read " + name);
    return content;
}

}  // namespace

std::string read_regular_file(const fs::path& file, std::uintmax_t max_bytes, const std::string& where) {
    const std::uintmax_t size = regular_size(file, where);
    if (size > max_bytes)
        throw SceneError(where, '"' + shown(file) + "\" has " + std::to_string(size) + " bytes, the limit is " + std::to_string(max_bytes));
    return read_bytes(file, size, where);
}

std::string read_head(const fs::path& file, std::size_t bytes, const std::string& where) {
    return read_bytes(file, std::min<std::uintmax_t>(regular_size(file, where), bytes), where);
}

}  // namespace pencil
