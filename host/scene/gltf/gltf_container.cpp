// A container: 12 bytes of header (magic, version, length), then chunks of 8 bytes of header (length, type) and content. The first chunk is
// JSON, the second, if any, the buffer without a name. https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html#binary-gltf-layout
#include "scene/gltf/gltf_container.h"

#include <algorithm>
#include <cstdint>

#include "util/error.h"

namespace pencil {
namespace {

constexpr std::size_t header_bytes = 12, chunk_header_bytes = 8;
constexpr std::uint64_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr int deepest = 64;                    // objects and arrays in each other; files nest to about 10
constexpr std::size_t most_objects = 2000000;  // a parser keeps hundreds of bytes for each

/// Little endian.
std::uint64_t number_at(std::string_view bytes, std::size_t at) {
    std::uint64_t value = 0;
    for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

std::string_view json_of_container(std::string_view bytes, const std::string& where) {
    if (bytes.size() < header_bytes + chunk_header_bytes) throw SceneError(where, "the file ends within its header");
    const std::uint64_t version = number_at(bytes, 4), length = number_at(bytes, 8);
    if (version != 2) throw SceneError(where, "glTF version " + std::to_string(version) + " is not supported" + advice_on_version);
    if (length > bytes.size()) {
        throw SceneError(
            where, "the file is truncated: it should have " + std::to_string(length) + " bytes and has " + std::to_string(bytes.size()));
    }
    std::string_view json;
    std::size_t at = header_bytes;
    for (int chunk = 0; chunk < 2 && at < length; ++chunk) {
        const std::string name = "chunk " + std::to_string(chunk);
        if (length - at < chunk_header_bytes) throw SceneError(where, name + " ends within its header");
        const std::uint64_t size = number_at(bytes, at), type = number_at(bytes, at + 4);
        at += chunk_header_bytes;
        if (size > length - at) throw SceneError(where, name + " is longer than the file");
        if (type != (chunk == 0 ? json_chunk : binary_chunk)) throw SceneError(where, name + " is not of the expected type");
        if (chunk == 0) json = bytes.substr(at, static_cast<std::size_t>(size));
        at += static_cast<std::size_t>(size);
    }
    return json;
}

void check_structure(std::string_view json, const std::string& where) {
    int depth = 0;
    std::size_t objects = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (in_string) {
            if (c == '\\') ++i;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '{' || c == '[') {
            if (++depth > deepest) throw SceneError(where, "objects are nested more than " + std::to_string(deepest) + " deep");
            if (c == '{' && ++objects > most_objects)
                throw SceneError(where, "there are more than " + std::to_string(most_objects) + " objects");
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
}

/// True if the key's value is an object.
bool holds_object(std::string_view json, std::string_view key) {
    constexpr std::string_view blanks = " \t\r\n";
    std::size_t at = json.find(key);
    if (at == std::string_view::npos) return false;
    at = json.find_first_not_of(blanks, at + key.size());
    if (at == std::string_view::npos || json[at] != ':') return false;
    at = json.find_first_not_of(blanks, at + 1);
    return at != std::string_view::npos && json[at] == '{';
}

}  // namespace

const std::string advice_on_version = "; 2.0 is: convert the file with \"gltf-pipeline -i OLD -o NEW\"";

bool is_gltf_1(std::string_view json) { return holds_object(json, "\"accessors\"") || holds_object(json, "\"meshes\""); }

bool is_glb(std::string_view bytes) { return bytes.substr(0, 4) == "glTF"; }

std::string_view checked_gltf_json(std::string_view bytes, const std::string& where) {
    const std::string_view json = is_glb(bytes) ? json_of_container(bytes, where) : bytes;
    check_structure(json, where);
    return json;
}

}  // namespace pencil
