// Pictures from files or memory, as numbers. What scenes name is untrusted: only formats of the list are opened, told by content, and sizes
// are judged before memory is taken.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec4.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace pencil {

struct DecodedImage {
    int width = 0, height = 0;
    bool is_encoded = false;   // stored as integers, whose values pictures encode by the sRGB curve
    bool is_bytes = false;     // of 8 bits
    bool has_opacity = false;  // else it is 1 everywhere
    std::vector<glm::vec4>
        texels;  // rows from the top: red, green, blue and opacity as stored, integers over the largest one; grey: thrice
};

constexpr std::uint64_t max_texels = std::uint64_t{1} << 27;  // of one picture: 16384 x 8192

/// The format by a file's first bytes, as OpenImageIO calls it; empty if it is none of the allowed ones. `size`: of the whole file.
std::string image_format(std::string_view head, std::uint64_t size);

/// SceneError at `where` for files that are missing, damaged, too large or of no allowed format.
DecodedImage decode_image_file(const std::filesystem::path& file, const std::string& where);

/// The same of a file's bytes; `name` is what messages call it.
DecodedImage decode_image_bytes(std::string_view bytes, const std::string& name, const std::string& where);

}  // namespace pencil
