// A row of an element is read value by value, from text or from bytes, by one of two sources with the same interface. The counts of the
// header are held against what is left of the file before anything is allocated.
#include "scene/meshes/read_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scene/meshes/ply_source.h"

namespace pencil {
namespace {

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
            else if (element.name == "face")
                faces(element);
            else
                skip(element);
        }
        check_indices();
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

    void vertices(const PlyElement& element) {
        const std::vector<int> position = columns(element, {"x", "y", "z"}), normal = columns(element, {"nx", "ny", "nz"}),
                               uv = uv_columns(element);
        const std::string where = name_ + ":" + std::to_string(element.header_line);
        if (position.empty()) throw SceneError(where, "element \"vertex\" needs the properties x, y and z");
        if (!mesh_.positions.empty()) throw SceneError(where, "element \"vertex\" is given twice");
        mesh_.positions.reserve(static_cast<std::size_t>(element.count));
        std::vector<double> row(element.properties.size());
        for (std::uint64_t i = 0; i < element.count; ++i) {
            source_.begin_row();
            for (std::size_t p = 0; p < row.size(); ++p) row[p] = value(element.properties[p]);
            source_.end_row();
            mesh_.positions.push_back(finite(row, position, "position", i));
            if (!normal.empty()) mesh_.normals.push_back(finite(row, normal, "normal", i));
            if (!uv.empty()) mesh_.uvs.emplace_back(finite(row, uv, "texture coordinate", i));
        }
    }

    /// The numbers of these columns, zero where there are fewer than three.
    glm::dvec3 finite(const std::vector<double>& row, const std::vector<int>& from, const char* what, std::uint64_t i) const {
        glm::dvec3 result(0.0);
        for (int c = 0; c < static_cast<int>(from.size()); ++c) {
            result[c] = row[static_cast<std::size_t>(from[static_cast<std::size_t>(c)])];
            if (!std::isfinite(result[c])) source_.fail("the " + std::string(what) + " of vertex " + std::to_string(i) + " is not finite");
        }
        return result;
    }

    void faces(const PlyElement& element) {
        const auto list = std::find_if(element.properties.begin(), element.properties.end(), [](const PlyProperty& p) {
            return p.is_list && (p.name == "vertex_indices" || p.name == "vertex_index");
        });
        const std::string where = name_ + ":" + std::to_string(element.header_line);
        if (list == element.properties.end()) throw SceneError(where, "element \"face\" needs a list property vertex_indices");
        if (!is_integer(list->type)) throw SceneError(where, "vertex indices must be integers");
        for (std::uint64_t i = 0; i < element.count; ++i) {
            source_.begin_row();
            for (const PlyProperty& property : element.properties)
                if (&property == &*list)
                    face(property, i);
                else
                    value(property);
            source_.end_row();
        }
    }

    void face(const PlyProperty& property, std::uint64_t number) {
        const std::uint64_t corners = list_length(property);
        if (corners < 3) source_.fail("face " + std::to_string(number) + " has " + std::to_string(corners) + " corners, fewer than 3");
        std::uint32_t first = 0, previous = 0;
        for (std::uint64_t c = 0; c < corners; ++c) {
            const double index = source_.read(property.type);
            if (!(index >= 0.0 && index < std::numeric_limits<std::uint32_t>::max()))
                source_.fail("face " + std::to_string(number) + " has a vertex index out of range");
            const auto corner = static_cast<std::uint32_t>(index);
            if (c == 0) first = corner;
            if (c >= 2) mesh_.triangles.emplace_back(first, previous, corner);
            previous = corner;
        }
        if (mesh_.triangles.size() > max_triangles) source_.fail("more than " + std::to_string(max_triangles) + " triangles");
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
};

}  // namespace

Mesh read_ply(std::string_view bytes, const std::string& name) {
    const PlyHeader header = parse_ply_header(bytes, name);
    if (header.encoding == PlyEncoding::ascii) return PlyReader<PlyText>(PlyText(bytes, header, name), header, name).read();
    return PlyReader<PlyBytes>(PlyBytes(bytes, header, name), header, name).read();
}

}  // namespace pencil
