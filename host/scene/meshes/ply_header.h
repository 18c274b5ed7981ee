// The header of a PLY file: what elements follow, with which properties, in which encoding.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pencil {

enum class PlyType { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class PlyEncoding { ascii, little_endian, big_endian };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::f32;
    bool is_list = false;
    PlyType count_type = PlyType::u8;  // of a list's length
};

struct PlyElement {
    std::string name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
    std::size_t header_line = 0;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t bytes = 0;  // up to and with the line "end_header"
    std::size_t lines = 0;
    char line_end = '\n';            // of the header, and of a body of text; CRs before LFs are blanks
    std::vector<std::string> notes;  // what was read over
};

std::size_t size_of(PlyType type);
bool is_integer(PlyType type);

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name);

}  // namespace pencil
