// One pass over the lines. An index may only name what stands above it. Corners with the same position, texture coordinate and normal
// become one vertex, so that where no normal is given seams of the texture stay edges (Mitsuba's rule). As a scene of its own the file is read
// by its smoothing groups instead, across such seams.
#include "scene/meshes/read_obj.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "scene/meshes/linear_of_srgb.h"
#include "scene/meshes/smoothing_groups.h"
#include "scene/meshes/triangulate.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr std::size_t max_line_bytes = std::size_t{64} << 20;  // a polygon of some million corners

/// Index of a position from 0, of texture coordinates and a normal from 1, 0 for none; the smoothing group where there is no normal.
struct Corner {
    std::size_t position, uv, normal, group;
    bool operator==(const Corner& other) const {
        return position == other.position && uv == other.uv && normal == other.normal && group == other.group;
    }
};

struct CornerHash {
    std::size_t operator()(const Corner& c) const {
        constexpr std::size_t spread = 0x9e3779b97f4a7c15;
        return ((c.position * spread ^ c.uv) * spread ^ c.normal) * spread ^ c.group;
    }
};

bool is_nowhere(const glm::dvec3& p) { return std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.z); }

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& name, bool as_scene) : text_(text), name_(name), as_scene_(as_scene) {}

    Mesh read() {
        std::string joined;
        while (at_ < text_.size()) statement(next_line(joined));
        if (positions_.empty() && !text_.empty() && !trimmed(text_).empty())
            throw SceneError(name_, "no vertex in the whole file: is it an OBJ file?");
        if (as_scene_ && groups_.assign(mesh_.triangles, mesh_.normals)) any_normal_ = true;
        if (!any_normal_) mesh_.normals.clear();
        if (!any_uv_) mesh_.uvs.clear();
        if (!any_colour_) mesh_.colours.clear();
        mesh_.smooth = !as_scene_;
        std::replace_if(mesh_.positions.begin(), mesh_.positions.end(), is_nowhere, glm::dvec3(0.0));  // of faces left out
        tell_what_is_left_out();
        return std::move(mesh_);
    }

private:
    void tell_what_is_left_out() {
        const auto tell = [&](std::size_t count, const char* what) {
            if (count > 0) mesh_.notes.push_back(std::to_string(count) + what);
        };
        tell(bad_normals_, " normals that are no numbers are left out");
        tell(thin_faces_, " faces of fewer than 3 corners are left out");
        tell(lost_faces_, " faces with vertices that are nowhere (NaN or infinite) are left out");
        tell(lacking_, " texture coordinates or normals that faces name and the file lacks are left out");
    }

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

    /// With those that continue it: a backslash at the end of any but a comment. `joined` holds such a line.
    std::string_view next_line(std::string& joined) {
        joined.clear();
        while (true) {
            ++line_;
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            const std::string_view line = text_.substr(at_, end - at_);
            at_ = end + 1;
            if (line.size() + joined.size() > max_line_bytes) fail("the line is longer than " + std::to_string(max_line_bytes) + " bytes");
            const std::string_view content = trimmed(line);
            const bool goes_on = !content.empty() && content.back() == '\\' && content[0] != '#' && at_ < text_.size();
            if (joined.empty() && !goes_on) return line;
            joined += goes_on ? content.substr(0, content.size() - 1) : content;
            joined += ' ';
            if (!goes_on) return joined;
        }
    }

    void statement(std::string_view line) {
        const std::string_view keyword = next_word(line);
        if (keyword.empty() || keyword[0] == '#') return;
        if (keyword == "v")
            position(line);
        else if (keyword == "vn")
            normals_.push_back(normal(line));
        else if (keyword == "vt")
            uvs_.push_back(texture_coordinate(line));
        else if (keyword == "f")
            face(line);
        else if (keyword.find('\0') != std::string_view::npos)
            fail("binary data: this is not an OBJ file");
        else
            other_statement(keyword, trimmed(line));
    }

    void other_statement(std::string_view keyword, std::string_view operand) {
        if (keyword == "mtllib") {
            mesh_.libraries.emplace_back(operand);
        } else if (keyword == "usemtl") {
            const auto [place, is_new] = materials_.emplace(operand, static_cast<std::uint32_t>(mesh_.materials.size()));
            if (is_new) mesh_.materials.emplace_back(operand);
            material_ = place->second;
        } else if (keyword == "s" && as_scene_) {
            const std::optional<long long> group = parse_integer(operand);  // or "off"
            group_ = group && *group > 0 ? static_cast<std::size_t>(*group) : 0;
        }
    }

    /// x y z, then perhaps w, or a colour, or both.
    void position(std::string_view line) {
        double values[7] = {};
        const int count = numbers("v", line, 3, 7, values);
        positions_.emplace_back(values[0], values[1], values[2]);
        any_nowhere_ = any_nowhere_ || is_nowhere(positions_.back());
        if (!as_scene_ || count < 6) return;
        colours_.resize(positions_.size(), glm::vec3(1.0F));
        for (int k = 0; k < 3; ++k) colours_.back()[k] = linear_of_srgb(values[count - 3 + k]);
    }

    /// What is no number is no normal: zero.
    glm::dvec3 normal(std::string_view line) {
        const std::vector<std::string_view> words = tokens(line);
        if (words.size() >= 3 && std::any_of(words.begin(), words.begin() + 3, is_no_number)) {
            ++bad_normals_;
            return glm::dvec3(0.0);
        }
        double values[3] = {};
        numbers("vn", line, 3, 3, values);
        return {values[0], values[1], values[2]};
    }

    /// u, then perhaps v and w. Exporters write what is no number, too, and nothing that is rendered today depends on it: that is 0.
    glm::dvec2 texture_coordinate(std::string_view line) const {
        glm::dvec2 uv(0.0);
        for (int k = 0; k < 2; ++k) uv[k] = parse_number(next_word(line)).value_or(0.0);
        return uv;
    }

    /// Their count; so many are in `values`, NaN for what is no number.
    int numbers(const char* keyword, std::string_view line, int at_least, int at_most, double* values) const {
        int count = 0;
        for (std::string_view word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line), ++count) {
            const std::optional<double> value = parse_number(word);
            if (!value && !is_no_number(word)) fail(std::string(keyword) + ": " + number_defect(word));
            if (count >= at_most) fail(std::string(keyword) + " has more than " + std::to_string(at_most) + " numbers");
            values[count] = value.value_or(std::numeric_limits<double>::quiet_NaN());
        }
        if (count < at_least) fail(std::string(keyword) + " has " + std::to_string(count) + " numbers, not " + std::to_string(at_least));
        return count;
    }

    void face(std::string_view line) {
        polygon_.clear();
        for (std::string_view word = next_word(line); !word.empty() && word[0] != '#'; word = next_word(line))
            polygon_.push_back(vertex(word));
        if (polygon_.size() < 3) {
            ++thin_faces_;
            return;
        }
        if (any_nowhere_ &&
            std::any_of(polygon_.begin(), polygon_.end(), [&](std::uint32_t i) { return is_nowhere(mesh_.positions[i]); })) {
            ++lost_faces_;
            return;
        }
        triangulate(polygon_, mesh_.positions, mesh_.triangles);
        if (mesh_.triangles.size() > max_triangles) fail("more than " + std::to_string(max_triangles) + " triangles");
        if (mesh_.materials.empty()) mesh_.materials.emplace_back();  // faces before the first usemtl
        mesh_.material.resize(mesh_.triangles.size(), material_);
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
        const std::size_t position = index(part[0], positions_.size(), word);
        if (position == 0) {
            fail("face corner " + in_quotes(word) + " names vertex " + std::string(part[0]) + ", but there are " +
                 std::to_string(positions_.size()) + " so far");
        }
        const std::size_t uv = optional_index(part[1], uvs_.size(), word), normal = optional_index(part[2], normals_.size(), word);
        const std::size_t group = normal > 0 ? 0 : group_;
        Mesh& mesh = mesh_;
        const auto [place, is_new] =
            vertices_.emplace(Corner{position - 1, uv, normal, group}, static_cast<std::uint32_t>(mesh.positions.size()));
        if (is_new) {
            mesh.positions.push_back(positions_[position - 1]);
            mesh.normals.push_back(normal > 0 ? normals_[normal - 1] : glm::dvec3(0.0));
            mesh.uvs.push_back(uv > 0 ? uvs_[uv - 1] : glm::vec2(0.0F));
            if (as_scene_) {
                mesh.colours.push_back(position <= colours_.size() ? colours_[position - 1] : glm::vec3(1.0F));
                groups_.add_vertex(positions_[position - 1], position - 1, group);
            }
            any_normal_ = any_normal_ || normal > 0;
            any_uv_ = any_uv_ || uv > 0;
            any_colour_ = any_colour_ || position <= colours_.size();
        }
        return place->second;
    }

    /// Files name what they lack where an exporter was told to write no normals, say: then 0, for none.
    std::size_t optional_index(std::string_view digits, std::size_t count, std::string_view word) {
        if (digits.empty()) return 0;
        const std::size_t result = index(digits, count, word);
        lacking_ += result == 0 ? 1 : 0;
        return result;
    }

    /// From 1, or from -1 backwards, to an index from 1; 0 if there is no such thing.
    std::size_t index(std::string_view digits, std::size_t count, std::string_view word) const {
        const std::optional<long long> value = parse_integer(digits);
        if (!value) fail("face corner " + in_quotes(word) + ": " + in_quotes(digits) + " is not an index");
        if (*value == 0) fail("face corner " + in_quotes(word) + ": indices start at 1");
        const auto n = static_cast<long long>(std::min<std::size_t>(count, std::numeric_limits<std::uint32_t>::max()));
        if (*value > n || *value < -n) return 0;
        return static_cast<std::size_t>(*value > 0 ? *value : n + *value + 1);
    }

    std::string_view text_;
    const std::string& name_;
    const bool as_scene_;
    std::size_t at_ = 0, line_ = 0;
    std::vector<glm::dvec3> positions_, normals_;
    std::vector<glm::vec2> uvs_;
    std::vector<glm::vec3> colours_;  // of positions; may be fewer
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices_;
    std::vector<std::uint32_t> polygon_;
    SmoothingGroups groups_;
    std::size_t group_ = 0, bad_normals_ = 0, thin_faces_ = 0, lost_faces_ = 0, lacking_ = 0;
    std::map<std::string, std::uint32_t, std::less<>> materials_;
    std::uint32_t material_ = 0;
    bool any_normal_ = false, any_uv_ = false, any_colour_ = false, any_nowhere_ = false;
    Mesh mesh_;
};

Mesh read_text(std::string_view text, const std::string& name, bool as_scene) {
    if (!has_encoding_mark(text)) return ObjReader(text, name, as_scene).read();
    const std::string decoded = decoded_by_mark(text);
    return ObjReader(decoded, name, as_scene).read();
}

}  // namespace

Mesh read_obj(std::string_view text, const std::string& name) { return read_text(text, name, false); }

Mesh read_obj_file(std::string_view text, const std::string& name) { return read_text(text, name, true); }

}  // namespace pencil
