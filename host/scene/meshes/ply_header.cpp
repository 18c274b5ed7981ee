// Lines end in LF or CRLF, or in CR alone, as Rhino writes them, and hold blank-separated words. Counts are only read here; the reader holds them against the file's size.
#include "scene/meshes/ply_header.h"

#include <map>

#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr std::size_t max_header_bytes = 64 * 1024;
constexpr std::size_t max_properties = 256;  // in all

const std::map<std::string_view, PlyType> type_names = {
    {"char", PlyType::i8},   {"int8", PlyType::i8},     {"uchar", PlyType::u8},   {"uint8", PlyType::u8},
    {"short", PlyType::i16}, {"int16", PlyType::i16},   {"ushort", PlyType::u16}, {"uint16", PlyType::u16},
    {"int", PlyType::i32},   {"int32", PlyType::i32},   {"uint", PlyType::u32},   {"uint32", PlyType::u32},
    {"float", PlyType::f32}, {"float32", PlyType::f32}, {"double", PlyType::f64}, {"float64", PlyType::f64}};

class HeaderParser {
public:
    HeaderParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    PlyHeader parse() {
        find_line_end();
        if (words() != std::vector<std::string_view>{"ply"}) fail("the first line is not \"ply\"");
        bool has_format = false;
        for (std::vector<std::string_view> line = words(); line.empty() || line[0] != "end_header"; line = words()) {
            if (line.empty() || line[0] == "comment" || line[0] == "obj_info") continue;
            if (line[0] == "format") {
                format(line);
                has_format = true;
            } else if (line[0] == "element") {
                element(line);
            } else if (line[0] == "property") {
                property(line);
            } else {
                unknown(line[0]);
            }
        }
        if (!has_format) fail("the header has no format line");
        return header_;
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw SceneError(name_ + ":" + std::to_string(header_.lines), message); }

    /// The first line tells: later ones may be followed by bytes of any value.
    void find_line_end() {
        const std::size_t end = bytes_.substr(0, max_header_bytes).find_first_of("\r\n");
        const bool is_mark = end != std::string_view::npos && bytes_[end] == '\r' && bytes_.substr(end + 1, 1) != "\n";
        header_.line_end = is_mark ? '\r' : '\n';
    }

    /// Programs forget the word "comment".
    void unknown(std::string_view word) {
        if (header_.notes.empty()) header_.notes.push_back("header lines that begin with " + in_quotes(word) + " or the like are left out");
    }

    std::vector<std::string_view> words() {
        ++header_.lines;
        const std::size_t end = bytes_.substr(0, max_header_bytes).find(header_.line_end, header_.bytes);
        if (end == std::string_view::npos)
            fail("the header has no line \"end_header\" in its first " + std::to_string(max_header_bytes) + " bytes");
        const std::string_view line = bytes_.substr(header_.bytes, end - header_.bytes);
        header_.bytes = end + 1;
        return tokens(line);
    }

    void format(const std::vector<std::string_view>& line) {
        if (line.size() != 3 || line[2] != "1.0") fail("the format line must be \"format ENCODING 1.0\"");
        if (line[1] == "ascii")
            header_.encoding = PlyEncoding::ascii;
        else if (line[1] == "binary_little_endian")
            header_.encoding = PlyEncoding::little_endian;
        else if (line[1] == "binary_big_endian")
            header_.encoding = PlyEncoding::big_endian;
        else
            fail("encoding " + in_quotes(line[1]) + " is not known");
    }

    void element(const std::vector<std::string_view>& line) {
        if (line.size() != 3) fail("an element line must be \"element NAME COUNT\"");
        const std::optional<long long> count = parse_integer(line[2]);
        if (!count || *count < 0) fail("element count " + in_quotes(line[2]) + " is not a number of things");
        header_.elements.push_back({std::string(line[1]), static_cast<std::uint64_t>(*count), {}, header_.lines});
    }

    void property(const std::vector<std::string_view>& line) {
        if (header_.elements.empty()) fail("a property stands before the first element");
        if (++properties_ > max_properties) fail("more than " + std::to_string(max_properties) + " properties");
        PlyProperty result;
        result.is_list = line.size() == 5 && line[1] == "list";
        if (!result.is_list && line.size() != 3) fail("a property line must be \"property TYPE NAME\" or \"property list TYPE TYPE NAME\"");
        if (result.is_list) {
            result.count_type = type(line[2]);
            if (!is_integer(result.count_type)) fail("the length of a list must be an integer, not " + in_quotes(line[2]));
        }
        result.type = type(line[line.size() - 2]);
        result.name = line.back();
        header_.elements.back().properties.push_back(result);
    }

    PlyType type(std::string_view word) const {
        const auto place = type_names.find(word);
        if (place == type_names.end()) fail("property type " + in_quotes(word) + " is not known");
        return place->second;
    }

    std::string_view bytes_;
    const std::string& name_;
    PlyHeader header_;
    std::size_t properties_ = 0;
};

}  // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
        case PlyType::i8:
        case PlyType::u8:
            return 1;
        case PlyType::i16:
        case PlyType::u16:
            return 2;
        case PlyType::f64:
            return 8;
        default:
            return 4;
    }
}

bool is_integer(PlyType type) { return type != PlyType::f32 && type != PlyType::f64; }

PlyHeader parse_ply_header(std::string_view bytes, const std::string& name) { return HeaderParser(bytes, name).parse(); }

}  // namespace pencil
