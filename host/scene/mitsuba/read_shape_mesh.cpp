#include "scene/mitsuba/read_shape_mesh.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "scene/meshes/read_obj.h"
#include "scene/meshes/read_ply.h"
#include "scene/meshes/read_serialized.h"
#include "scene/scene_file.h"

namespace pencil {
namespace {

double positive(Properties& p, const std::string& name) {
    const double value = p.number(name, 1.0);
    if (!(value > 0.0)) p.fail(name, name + " must be positive");
    return value;
}

Mesh read_file(Properties& p, const std::string& kind) {
    p.ignore({"max_smooth_angle", "collapse", "srgb", "load_materials", "flip_tex_coords"});
    if (!p.has("filename")) p.fail("", "needs a filename");
    const std::string where = p.source().where(p.node());
    const std::filesystem::path file = p.source().find_file(p.text("filename", ""), p.node());
    const std::string bytes = read_regular_file(file, max_mesh_bytes, where), name = shown(file);
    const long long index = p.integer("shape_index", 0);
    if (kind == "serialized" && index < 0) p.fail("shape_index", "shape_index must not be negative");
    if (kind != "serialized" && index >= 0 && p.has("shape_index"))
        p.approximate("shape_index", "parts of such a file are not told apart: all of it is read");
    Mesh mesh = kind == "obj"   ? read_obj(bytes, name)
                : kind == "ply" ? read_ply(bytes, name)
                                : read_serialized(bytes, static_cast<std::size_t>(index), name);
    if (p.boolean("flip_tex_coords", kind == "obj"))
        for (glm::vec2& uv : mesh.uvs) uv.y = 1.0F - uv.y;
    return mesh;
}

/// From the unit cylinder to that around the line from p0 to p1.
glm::dmat4 cylinder_frame(Properties& p) {
    const glm::dvec3 begin = p.vector("p0", glm::dvec3(0, 0, 0)), axis = p.vector("p1", glm::dvec3(0, 0, 1)) - begin;
    const double radius = positive(p, "radius"), length = glm::length(axis);
    if (!(length > 0.0) || !std::isfinite(length)) p.fail("p1", "p0 and p1 are the same point");
    const glm::dvec3 z = axis / length, other = std::abs(z.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = glm::normalize(other - z * glm::dot(other, z)), y = glm::cross(z, x);
    return {glm::dvec4(x * radius, 0), glm::dvec4(y * radius, 0), glm::dvec4(axis, 0), glm::dvec4(begin, 1)};
}

}  // namespace

bool is_known_shape(const std::string& kind) {
    const std::vector<std::string> kinds = {"rectangle", "cube", "sphere", "disk", "cylinder", "obj", "ply", "serialized"};
    return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

Mesh read_shape_mesh(Properties& p, const std::string& kind) {
    if (kind == "rectangle") return make_rectangle();
    if (kind == "cube") return make_cube();
    if (kind == "disk") return make_disk();
    if (kind == "cylinder") return make_cylinder();
    return read_file(p, kind);
}

glm::dmat4 shape_to_world(Properties& p, const std::string& kind) {
    const glm::dmat4 to_world = p.placement("to_world");
    const bool is_closed = kind == "cube" || kind == "sphere" || kind == "cylinder";
    if (is_closed && is_flat(to_world))
        p.fail("to_world", "the " + kind + " is flattened, so that its two sides lie in one place; use a rectangle or a disk");
    if (kind == "cylinder") return to_world * cylinder_frame(p);
    if (kind != "sphere") return to_world;
    const glm::dvec3 center = p.vector("center", glm::dvec3(0.0));
    const double radius = positive(p, "radius");
    return to_world * glm::dmat4(radius, 0, 0, 0, 0, radius, 0, 0, 0, 0, radius, 0, center.x, center.y, center.z, 1);
}

}  // namespace pencil
