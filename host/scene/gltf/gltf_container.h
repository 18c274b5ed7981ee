// What holds the JSON of a glTF file: the text itself (.gltf), or a binary container (.glb). Checked here before a parser sees it.
#pragma once

#include <string>
#include <string_view>

namespace pencil {

/// What to do with a file of another version, for messages.
extern const std::string advice_on_version;

/// True if objects have names in the JSON, as in version 1.0, and not indices.
bool is_gltf_1(std::string_view json);

/// True if the bytes begin as a binary container does.
bool is_glb(std::string_view bytes);

/// The JSON text inside. SceneError blaming `where` for a container whose lengths lie, one of another version, and for text that nests so
/// deeply that parsers, which call themselves at every level, run out of stack, or has so many objects that they run out of memory.
std::string_view checked_gltf_json(std::string_view bytes, const std::string& where);

}  // namespace pencil
