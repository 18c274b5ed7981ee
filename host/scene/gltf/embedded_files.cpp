#include "scene/gltf/embedded_files.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace pencil {
namespace {

constexpr std::string_view prefix = "embedded data ", scheme = "data:", marker = ";base64,";
constexpr std::size_t shortest = 4096;  // parsers may have the others

/// What follows the marker of a data URI; empty if `text` is none or has escapes of JSON.
std::string_view content_of(std::string_view text) {
    constexpr std::size_t longest_head = 200;
    if (text.size() < shortest || text.substr(0, scheme.size()) != scheme) return {};
    const std::size_t at = text.substr(0, longest_head).find(marker);
    if (at == std::string_view::npos || text.find('\\') != std::string_view::npos) return {};
    return text.substr(at + marker.size());
}

std::array<std::int8_t, 256> make_values() {
    std::array<std::int8_t, 256> values;
    values.fill(-1);
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (std::size_t i = 0; i < digits.size(); ++i) values[static_cast<unsigned char>(digits[i])] = static_cast<std::int8_t>(i);
    return values;
}

}  // namespace

EmbeddedFiles::EmbeddedFiles(std::string_view json) {
    std::size_t kept = 0;  // up to here the text is in json_, or taken out
    for (std::size_t begin = json.find('"'); begin != std::string_view::npos; begin = json.find('"', begin)) {
        std::size_t end = ++begin;
        while (end < json.size() && json[end] != '"') end += json[end] == '\\' ? 2 : 1;
        if (end >= json.size()) break;
        const std::string_view content = content_of(json.substr(begin, end - begin));
        if (!content.empty()) {
            json_.append(json.substr(kept, begin - kept)).append(prefix).append(std::to_string(contents_.size()));
            contents_.push_back(content);
            kept = end;
        }
        begin = end + 1;
    }
    json_.append(json.substr(kept));
}

std::size_t EmbeddedFiles::index_of(const std::string& name) const {
    std::size_t index = contents_.size();
    if (name.compare(0, prefix.size(), prefix) == 0) std::from_chars(name.data() + prefix.size(), name.data() + name.size(), index);
    return index;
}

bool EmbeddedFiles::decode(const std::string& name, std::vector<unsigned char>& bytes) const {
    static const std::array<std::int8_t, 256> values = make_values();
    std::string_view content = contents_.at(index_of(name));
    while (!content.empty() && content.back() == '=') content.remove_suffix(1);
    bytes.clear();
    bytes.reserve(content.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < content.size(); ++i) {
        const std::int8_t value = values[static_cast<unsigned char>(content[i])];
        if (value < 0) return false;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if (i % 4 != 0) bytes.push_back(static_cast<unsigned char>(bits >> (6 - i % 4 * 2) & 255));
    }
    return true;
}

}  // namespace pencil
