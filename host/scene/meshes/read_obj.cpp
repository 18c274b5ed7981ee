// One pass over the lines. An index may only name what stands above it. Corners with the same position, texture coordinate and normal
// become one vertex, so that where no normal is given seams of the texture stay edges (Mitsuba's rule).
#include "scene/meshes/read_obj.h"

#include <cmath>
#include <limits>
#include <unordered_map>

#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr std::size_t max_line_bytes = std::size_t{64} << 20;  // a polygon of some million corners

/// Index of a position from 0, of texture coordinates and a normal from 1, 0 for none.
struct Corner {
    std::size_t position, uv, normal;
    bool operator==(const Corner& other) const { return position == other.position && uv == other.uv && normal == other.normal; }
};

struct CornerHash {
    std::size_t operator()(const Corner& c) const { return (c.position * 0x9e3779b97f4a7c15 ^ c.uv) * 0x9e3779b97f4a7c15 ^ c.normal; }
};

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    Mesh read() {
        for (std::size_t start = 0; start < text_.size(); ++line_) {
            const std::size_t end = std::min(text_.find('\n', start), text_.size());
            if (end - start > max_line_bytes) fail("the line is longer than " + std::to_string(max_line_bytes) + " bytes");
            statement(text_.substr(start, end - start));
            start = end + 1;
        }
        if (positions_.empty() && !text_.empty() && !trimmed(text_).empty())
            throw SceneError(name_, "no vertex in the whole file: is it an OBJ file?");
        if (!any_normal_) mesh_.normals.clear();
        if (!any_uv_) mesh_.uvs.clear();
        mesh_.smooth = true;
        return std::move(mesh_);
    }

private:
    [[noreturn]] void fail(const std::string& message) const { throw SceneError(name_ + ":" + std::to_string(line_), message); }

    /// Cuts the next blank-separated word off `rest`.
    static std::string_view next_word(std::string_view& rest) {
        constexpr std::string_view blanks = " \t\r";
        const std::size_t first = std::min(rest.find_first_not_of(blanks), rest.size());
        const std::size_t end = std::min(rest.find_first_of(blanks, first), rest.size());
        const std::string_view word = rest.substr(first, end - first);
        rest.remove_prefix(end);
        return word;
    }

    void statement(std::string_view line) {
        const std::string_view keyword = next_word(line);
        if (keyword.empty() || keyword[0] == '#') return;
        if (const std::string_view rest = trimmed(line); !rest.empty() && rest.back() == '\\')
            fail("lines continued with \\ are not supported");
        if (keyword == "v")
            positions_.push_back(numbers("v", line, 3, 7));  // x y z, then perhaps w or a colour
        else if (keyword == "vn")
            normals_.push_back(numbers("vn", line, 3, 3));
        else if (keyword == "vt")
            uvs_.push_back(texture_coordinate(line));
        else if (keyword == "f")
            face(line);
        else if (keyword.find('\0') != std::string_view::npos)
            fail("binary data: this is not an OBJ file");
    }

    /// u, then perhaps v and w. Exporters write what is no number, too, and nothing that is rendered today depends on it: that is 0.
    glm::dvec2 texture_coordinate(std::string_view line) const {
        glm::dvec2 uv(0.0);
        for (int k = 0; k < 2; ++k) uv[k] = parse_number(next_word(line)).value_or(0.0);
        return uv;
    }

    /// The first three of them; zero where there are fewer.
    glm::dvec3 numbers(const char* keyword, std::string_view line, int at_least, int at_most) const {
        glm::dvec3 result(0.0);
        int count = 0;
        for (std::string_view word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line), ++count) {
            const std::optional<double> value = parse_number(word);
            if (!value) fail(std::string(keyword) + ": " + number_defect(word));
            if (count >= at_most) fail(std::string(keyword) + " has more than " + std::to_string(at_most) + " numbers");
            if (count < 3) result[count] = *value;
        }
        if (count < at_least) fail(std::string(keyword) + " has " + std::to_string(count) + " numbers, not " + std::to_string(at_least));
        return result;
    }

    void face(std::string_view line) {
        std::uint32_t first = 0, previous = 0;
        std::size_t count = 0;
        for (std::string_view word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line), ++count) {
            const std::uint32_t corner = vertex(word);
            if (count == 0) first = corner;
            if (count >= 2) mesh_.triangles.emplace_back(first, previous, corner);
            previous = corner;
        }
        if (count < 3) fail("a face needs at least 3 corners, this one has " + std::to_string(count));
        if (mesh_.triangles.size() > max_triangles) fail("more than " + std::to_string(max_triangles) + " triangles");
    }

    /// "p", "p/t", "p//n" or "p/t/n".
    std::uint32_t vertex(std::string_view word) {
        std::string_view part[3];
        std::size_t parts = 0;
        for (std::string_view rest = word;; ++parts) {
            if (parts == 3) fail("face corner " + in_quotes(word) + " has more than three indices");
            const std::size_t slash = rest.find('/');
            part[parts] = rest.substr(0, slash);
            if (slash == std::string_view::npos) break;
            rest.remove_prefix(slash + 1);
        }
        const std::size_t position = index(part[0], positions_.size(), "vertex", word);
        const std::size_t uv = part[1].empty() ? 0 : index(part[1], uvs_.size(), "texture coordinate", word) + 1;
        const std::size_t normal = part[2].empty() ? 0 : index(part[2], normals_.size(), "normal", word) + 1;
        const auto [place, is_new] = vertices_.emplace(Corner{position, uv, normal}, static_cast<std::uint32_t>(mesh_.positions.size()));
        if (is_new) {
            mesh_.positions.push_back(positions_[position]);
            mesh_.normals.push_back(normal > 0 ? normals_[normal - 1] : glm::dvec3(0.0));
            mesh_.uvs.push_back(uv > 0 ? uvs_[uv - 1] : glm::vec2(0.0F));
            any_normal_ = any_normal_ || normal > 0;
            any_uv_ = any_uv_ || uv > 0;
        }
        return place->second;
    }

    /// From 1, or from -1 backwards, to an index from 0.
    std::size_t index(std::string_view digits, std::size_t count, const char* what, std::string_view word) const {
        const std::optional<long long> value = parse_integer(digits);
        if (!value) fail("face corner " + in_quotes(word) + ": " + in_quotes(digits) + " is not an index");
        if (*value == 0) fail("face corner " + in_quotes(word) + ": indices start at 1");
        const auto n = static_cast<long long>(std::min<std::size_t>(count, std::numeric_limits<std::uint32_t>::max()));
        if (*value > n || *value < -n) {
            fail("face corner " + in_quotes(word) + " names " + what + " " + std::to_string(*value) + ", but there are " +
                 std::to_string(n) + " so far");
        }
        return static_cast<std::size_t>(*value > 0 ? *value - 1 : n + *value);
    }

    std::string_view text_;
    const std::string& name_;
    std::size_t line_ = 1;
    std::vector<glm::dvec3> positions_, normals_;
    std::vector<glm::vec2> uvs_;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
    bool any_normal_ = false, any_uv_ = false;
    Mesh mesh_;
};

}  // namespace

Mesh read_obj(std::string_view text, const std::string& name) { return ObjReader(text, name).read(); }

}  // namespace pencil
