// A row of an element is read value by value, from text or from bytes, by one of two sources with the same interface. The counts of the
// header are held against what is left of the file before anything is allocated.
#include "scene/meshes/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/meshes/linear_of_srgb.h"
#include "scene/meshes/nowhere.h"
#include "scene/meshes/ply_source.h"
#include "scene/meshes/triangulate.h"

namespace pencil {
namespace {

struct Polygon {
    std::uint32_t first_triangle, corners;
};

double largest_of(PlyType type) {
    const bool is_signed = type == PlyType::i8 || type == PlyType::i16 || type == PlyType::i32;
    return std::pow(2.0, static_cast<double>(8 * size_of(type)) - (is_signed ? 1 : 0)) - 1;
}

template <class Source>
class PlyReader {
public:
    PlyReader(Source source, const PlyHeader& header, const std::string& name) : source_(source), header_(header), name_(name) {}

    Mesh read() {
        const bool has_vertices =
            std::any_of(header_.elements.begin(), header_.elements.end(), [](const PlyElement& e) { return e.name == "vertex"; });
        if (!has_vertices) throw SceneError(name_, "the file has no element \"vertex\"");
        for (const PlyElement& element : header_.elements) {
            check_count(element);
            if (element.name == "vertex")
                vertices(element);
            else if (element.name == "face" || element.name == "tristrips")
                faces(element);
            else
                skip(element);
        }
        check_indices();
        cut_concave_faces();
        mesh_.notes.insert(mesh_.notes.end(), header_.notes.begin(), header_.notes.end());
        if (thin_faces_ > 0) mesh_.notes.push_back(std::to_string(thin_faces_) + " faces of fewer than 3 corners are left out");
        leave_out_nowhere(bad_positions_, mesh_);
        if (bad_normals_ > 0) mesh_.notes.push_back(std::to_string(bad_normals_) + " normals that are not finite are left out");
        mesh_.smooth = true;
        return std::move(mesh_);
    }

private:
    /// Division instead of multiplication: the product of a lying count may overflow.
    void check_count(const PlyElement& element) const {
        std::uint64_t row_bytes = 0;
        for (const PlyProperty& property : element.properties)
            row_bytes += Source::least_bytes(property.is_list ? property.count_type : property.type);
        const std::string where = name_ + ":" + std::to_string(element.header_line);
        if (row_bytes == 0 && element.count > 0) throw SceneError(where, "element " + in_quotes(element.name) + " has no properties");
        if (row_bytes > 0 && element.count > source_.left() / row_bytes) {
            throw SceneError(where, "the file ends too early: it cannot hold " + std::to_string(element.count) + " of element " +
                                        in_quotes(element.name));
        }
        if (element.count > std::numeric_limits<std::uint32_t>::max() - 1)
            throw SceneError(where, "too many of element " + in_quotes(element.name));
    }

    static int index_of(const PlyElement& element, const char* name) {
        const auto place = std::find_if(element.properties.begin(), element.properties.end(),
                                        [&](const PlyProperty& p) { return !p.is_list && p.name == name; });
        return place == element.properties.end() ? -1 : static_cast<int>(place - element.properties.begin());
    }

    /// Empty unless the element has all of these.
    static std::vector<int> columns(const PlyElement& element, std::initializer_list<const char*> names) {
        std::vector<int> found;
        for (const char* name : names) found.push_back(index_of(element, name));
        return *std::min_element(found.begin(), found.end()) < 0 ? std::vector<int>() : found;
    }

    /// Programs differ in the names.
    static std::vector<int> uv_columns(const PlyElement& element) {
        for (const auto& names :
             {std::array{"u", "v"}, std::array{"s", "t"}, std::array{"texture_u", "texture_v"}, std::array{"texture_s", "texture_t"}}) {
            std::vector<int> found = columns(element, {names[0], names[1]});
            if (!found.empty()) return found;
        }
        return {};
    }

    static std::vector<int> colour_columns(const PlyElement& element) {
        const std::vector<int> found = columns(element, {"r", "g", "b"});
        return found.empty() ? columns(element, {"red", "green", "blue"}) : found;
    }

    void vertices(const PlyElement& element) {
        const std::vector<int> position = columns(element, {"x", "y", "z"}), normal = columns(element, {"nx", "ny", "nz"}),
                               uv = uv_columns(element), colour = colour_columns(element);
        const std::string where = name_ + ":" + std::to_string(element.header_line);
        if (position.empty()) throw SceneError(where, "element \"vertex\" needs the properties x, y and z");
        if (!mesh_.positions.empty()) throw SceneError(where, "element \"vertex\" is given twice");
        mesh_.positions.reserve(static_cast<std::size_t>(element.count));
        std::vector<double> row(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            source_.begin_row();
            for (std::size_t p = 0; p < row.size(); ++p) row[p] = value(element.properties[p]);
            source_.end_row();
            mesh_.positions.push_back(finite_position(row, position));
            if (!normal.empty()) mesh_.normals.push_back(normal_of(row, normal));
            if (!colour.empty()) mesh_.colours.push_back(colour_of(row, colour, element));
            if (!uv.empty()) mesh_.uvs.emplace_back(finite_uv(row, uv));
        }
    }

    /// Zero, which is none, instead of what is no direction.
    glm::dvec3 normal_of(const std::vector<double>& row, const std::vector<int>& from) {
        glm::dvec3 result(0.0);
        for (int c = 0; c < 3; ++c) result[c] = row[static_cast<std::size_t>(from[static_cast<std::size_t>(c)])];
        if (is_finite(result)) return result;
        ++bad_normals_;
        return glm::dvec3(0.0);
    }

    /// Integers are values of a screen, from 0 to the largest of their type; floating-point ones are linear.
    static glm::vec3 colour_of(const std::vector<double>& row, const std::vector<int>& from, const PlyElement& element) {
        glm::vec3 result(0.0F);
        for (int c = 0; c < 3; ++c) {
            const auto column = static_cast<std::size_t>(from[static_cast<std::size_t>(c)]);
            const PlyType type = element.properties[column].type;
            if (is_integer(type))
                result[c] = linear_of_srgb(row[column] / largest_of(type));
            else
                result[c] = std::isfinite(row[column]) ? static_cast<float>(std::clamp(row[column], 0.0, 1.0)) : 0.0F;
        }
        return result;
    }

    /// Zero, and remembered, where a number is not finite, as scanners write it for what they did not see.
    glm::dvec3 finite_position(const std::vector<double>& row, const std::vector<int>& from) {
        glm::dvec3 result(0.0);
        for (int c = 0; c < 3; ++c) result[c] = row[static_cast<std::size_t>(from[static_cast<std::size_t>(c)])];
        if (is_finite(result)) return result;
        bad_positions_.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
        return glm::dvec3(0.0);
    }

    static glm::vec2 finite_uv(const std::vector<double>& row, const std::vector<int>& from) {
        glm::vec2 result(0.0F);
        for (int c = 0; c < 2; ++c) {
            const double value = row[static_cast<std::size_t>(from[static_cast<std::size_t>(c)])];
            result[c] = std::isfinite(value) ? static_cast<float>(value) : 0.0F;
        }
        return result;
    }

    void faces(const PlyElement& element) {
        const auto list = std::find_if(element.properties.begin(), element.properties.end(), [](const PlyProperty& p) {
            return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
        });
        const std::string where = name_ + ":" + std::to_string(element.header_line);
        const bool strips = element.name == "tristrips";
        if (list == element.properties.end())
            throw SceneError(where, "element " + in_quotes(element.name) + " needs a list property vertex_indices");
        if (!is_integer(list->type)) throw SceneError(where, "vertex indices must be integers");
        for (const PlyProperty& property : element.properties)
            if (property.is_list && property.name == "texcoord")
                note("texture coordinates of faces are left out; those of vertices are read");
        for (std::uint64_t i = 0; i < element.count; ++i) {
            source_.begin_row();
            for (const PlyProperty& property : element.properties)
                if (&property == &*list)
                    strips ? strip(property) : face(property, "face " + std::to_string(i));
                else
                    value(property);
            source_.end_row();
        }
    }

    void face(const PlyProperty& property, const std::string& label) {
        const std::uint64_t corners = list_length(property);
        thin_faces_ += corners < 3 ? 1 : 0;
        if (corners > 3) polygons_.push_back({static_cast<std::uint32_t>(mesh_.triangles.size()), static_cast<std::uint32_t>(corners)});
        std::uint32_t first = 0, previous = 0;
        for (std::uint64_t c = 0; c < corners; ++c) {
            const std::uint32_t corner = index(source_.read(property.type), label);
            if (c == 0) first = corner;
            if (c >= 2) add_triangle(first, previous, corner);
            previous = corner;
        }
    }

    /// Faces are fans so far, since they may stand before the vertices. Those with a vertex that is nowhere are left as they are.
    void cut_concave_faces() {
        std::vector<std::uint32_t> corners;
        std::vector<glm::uvec3> triangles;
        for (const Polygon& polygon : polygons_) {
            const auto fan = mesh_.triangles.begin() + polygon.first_triangle;
            corners = {fan->x, fan->y};
            for (std::uint32_t i = 0; i + 2 < polygon.corners; ++i) corners.push_back((fan + i)->z);
            if (std::any_of(corners.begin(), corners.end(), [&](std::uint32_t corner) { return is_nowhere(corner); })) continue;
            triangles.clear();
            triangulate(corners, mesh_.positions, triangles);
            std::copy(triangles.begin(), triangles.end(), fan);  // as many
        }
    }

    bool is_nowhere(std::uint32_t corner) const { return std::binary_search(bad_positions_.begin(), bad_positions_.end(), corner); }

    /// Strips end at -1; every other triangle of one is wound the other way round.
    void strip(const PlyProperty& property) {
        std::uint32_t last[2] = {0, 0};
        std::uint64_t corners = 0;  // of this strip, so far
        for (std::uint64_t left = list_length(property); left > 0; --left) {
            const double value = source_.read(property.type);
            if (value == -1) {
                corners = 0;
                continue;
            }
            const std::uint32_t corner = index(value, "a strip");
            if (corners >= 2) corners % 2 == 0 ? add_triangle(last[0], last[1], corner) : add_triangle(last[1], last[0], corner);
            ++corners;
            last[0] = last[1];
            last[1] = corner;
        }
    }

    std::uint32_t index(double value, const std::string& user) const {
        if (!(value >= 0.0 && value < std::numeric_limits<std::uint32_t>::max())) source_.fail(user + " has a vertex index out of range");
        return static_cast<std::uint32_t>(value);
    }

    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        mesh_.triangles.emplace_back(a, b, c);
        if (mesh_.triangles.size() > max_triangles) source_.fail("more than " + std::to_string(max_triangles) + " triangles");
    }

    void note(const std::string& text) {
        if (std::find(mesh_.notes.begin(), mesh_.notes.end(), text) == mesh_.notes.end()) mesh_.notes.push_back(text);
    }

    std::uint64_t list_length(const PlyProperty& property) {
        const double length = source_.read(property.count_type);
        const std::uint64_t most = source_.left_for_list() / Source::least_bytes(property.type);  // whole entries
        if (!(length >= 0.0 && length <= static_cast<double>(most))) source_.fail("a list has an impossible length");
        return static_cast<std::uint64_t>(length);
    }

    /// A scalar's value; a list is read over.
    double value(const PlyProperty& property) {
        if (!property.is_list) return source_.read(property.type);
        for (std::uint64_t left = list_length(property); left > 0; --left) source_.read(property.type);
        return 0.0;
    }

    void skip(const PlyElement& element) {
        for (std::uint64_t i = 0; i < element.count; ++i) {
            source_.begin_row();
            for (const PlyProperty& property : element.properties) value(property);
            source_.end_row();
        }
    }

    /// Only now: faces may stand before the vertices.
    void check_indices() const {
        for (const glm::uvec3 t : mesh_.triangles) {
            const std::uint32_t largest = std::max({t.x, t.y, t.z});
            if (largest >= mesh_.positions.size()) {
                throw SceneError(
                    name_, "a face names vertex " + std::to_string(largest) + ", but there are " + std::to_string(mesh_.positions.size()));
            }
        }
    }

    Source source_;
    const PlyHeader& header_;
    const std::string& name_;
    Mesh mesh_;
    std::size_t bad_normals_ = 0, thin_faces_ = 0;
    std::vector<Polygon> polygons_;             // of more than three corners
    std::vector<std::uint32_t> bad_positions_;  // ascending
};

}  // namespace

Mesh read_ply(std::string_view bytes, const std::string& name) {
    const PlyHeader header = parse_ply_header(bytes, name);
    if (header.encoding == PlyEncoding::ascii) return PlyReader<PlyText>(PlyText(bytes, header, name), header, name).read();
    return PlyReader<PlyBytes>(PlyBytes(bytes, header, name), header, name).read();
}

}  // namespace pencil
