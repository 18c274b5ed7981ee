#include "scene/mitsuba/read_shape.h"

#include <optional>

#include "scene/meshes/read_obj.h"
#include "scene/meshes/read_ply.h"
#include "scene/mitsuba/read_bsdf.h"
#include "scene/mitsuba/read_emitter.h"
#include "scene/scene_file.h"
#include "scene/text.h"

namespace pencil {

void ShapeReader::read(pugi::xml_node node) {
    Properties p(source_, node);
    Shape shape;
    shape.kind = node.attribute("type").value();
    const Mesh mesh = read_mesh(p, shape.kind);
    const std::string ordinal = std::to_string(++ordinals_[shape.kind]);
    shape.id = node.attribute("id") ? std::string(node.attribute("id").value()) : shape.kind + " " + ordinal;
    read_emission(p, shape);
    place(p, mesh, shape, material_of(p, shape.emits));
}

std::uint32_t ShapeReader::add_material(SceneMaterial material) {
    scene_.materials.push_back(std::move(material));
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
}

/// The shape's own, or Mitsuba's for shapes that name none: grey, or black if they emit.
std::uint32_t ShapeReader::material_of(Properties& p, bool emits) {
    std::optional<std::uint32_t> found;
    for (const NestedObject& object : p.objects()) {
        if (object.kind != "bsdf") continue;
        if (found) source_.fail(object.named_at, p.label() + " has more than one bsdf");
        const auto place = materials_.find(object.node.hash_value());
        found = place != materials_.end() ? place->second : add_material(read_bsdf(source_, object.node));
        materials_[object.node.hash_value()] = *found;
    }
    if (found) return *found;
    std::int64_t& index = default_material_[emits ? 1 : 0];
    if (index < 0) index = add_material({emits ? "default (emitter)" : "default", MATERIAL_DIFFUSE, glm::vec3(emits ? 0.0F : 0.5F)});
    return static_cast<std::uint32_t>(index);
}

/// Also refuses objects that have no business in a shape.
void ShapeReader::read_emission(Properties& p, Shape& shape) {
    for (const NestedObject& object : p.objects()) {
        if (object.kind == "bsdf") continue;
        if (object.kind != "emitter") p.fail_nested(object);
        if (shape.emits) source_.fail(object.named_at, p.label() + " has more than one emitter");
        shape.radiance = read_radiance(source_, object);
        shape.emits = true;
    }
}

Mesh ShapeReader::read_mesh(Properties& p, const std::string& kind) {
    if (kind == "rectangle") return make_rectangle();
    if (kind == "cube") return make_cube();
    if (kind == "sphere") return make_sphere();
    if (kind != "obj" && kind != "ply")
        source_.fail(p.node(), p.label() + " is not supported; supported: rectangle, cube, sphere, obj, ply");
    p.ignore({"max_smooth_angle", "collapse", "srgb"});
    const std::string name = p.text("filename", "");
    if (!p.has("filename")) p.fail("", "needs a filename");
    const std::string where = source_.where(p.node());
    const std::filesystem::path file = path_inside(source_.file().parent_path(), name, where);
    const std::string bytes = read_regular_file(file, max_mesh_bytes, where);
    Mesh mesh = kind == "obj" ? read_obj(bytes, shown(file)) : read_ply(bytes, shown(file));
    if (p.boolean("flip_tex_coords", kind == "obj"))
        for (glm::vec2& uv : mesh.uvs) uv.y = 1.0F - uv.y;
    return mesh;
}

/// The sphere's own centre and radius come before to_world.
glm::dmat4 ShapeReader::object_to_world(Properties& p, const std::string& kind) {
    const glm::dmat4 to_world = p.transform("to_world");
    if (kind != "sphere") return to_world;
    const glm::dvec3 center = p.vector("center", glm::dvec3(0.0));
    const double radius = p.number("radius", 1.0);
    if (!(radius > 0.0)) p.fail("radius", "radius must be positive");
    return to_world * glm::dmat4(radius, 0, 0, 0, 0, radius, 0, 0, 0, 0, radius, 0, center.x, center.y, center.z, 1);
}

void ShapeReader::place(Properties& p, const Mesh& mesh, Shape shape, std::uint32_t material) {
    Placement placement;
    placement.to_world = object_to_world(p, shape.kind);
    placement.flip_normals = p.boolean("flip_normals", false);
    placement.face_normals = p.boolean("face_normals", false);
    p.finish();
    shape.first_triangle = static_cast<std::uint32_t>(scene_.triangles.size());
    const auto number = static_cast<std::uint32_t>(scene_.shapes.size());
    const PlacementCounts counts = place_mesh(mesh, placement, {number, material}, source_.where(p.node()), scene_);
    shape.triangle_count = static_cast<std::uint32_t>(scene_.triangles.size()) - shape.first_triangle;
    const std::string label = p.label() + " " + in_quotes(shape.id);
    if (counts.dropped > 0) source_.warn(p.node(), label + ": " + std::to_string(counts.dropped) + " triangles of zero area left out");
    if (counts.turned > 0) {
        source_.warn(p.node(), label + ": " + std::to_string(counts.turned) +
                                   " triangles wound against their vertex normals; the normals say which side is the front");
    }
    if (shape.triangle_count == 0) source_.warn(p.node(), label + " has no triangles");
    scene_.shapes.push_back(std::move(shape));
}

}  // namespace pencil
