#include "scene/mitsuba/read_shape.h"

#include <algorithm>
#include <utility>

#include "scene/meshes/mesh_parts.h"
#include "scene/mitsuba/read_shape_mesh.h"
#include "scene/text.h"

namespace pencil {
namespace {

/// As the file spells it: it is the file's, not a parameter's.
std::string name_of(const NestedObject& object) { return object.named_at.attribute("name").value(); }

/// True also if it names none.
bool names_one_of(const Mesh& mesh, const NestedObject& bsdf) {
    const std::string name = name_of(bsdf);
    return name.empty() || std::find(mesh.materials.begin(), mesh.materials.end(), name) != mesh.materials.end();
}

/// As many as make a sphere of so many divisions.
std::size_t triangles_of_sphere(int divisions) { return std::size_t{20} << (2 * divisions); }

}  // namespace

void ShapeReader::expect(const std::vector<pugi::xml_node>& nodes) {
    constexpr std::size_t most = std::size_t{1} << 22;  // triangles of all spheres, while each has the least
    std::size_t spheres = 0;
    for (const pugi::xml_node node : nodes)
        if (std::string_view(node.name()) == "shape") spheres += spheres_of(node);
    int divisions = 3;
    while (divisions > 1 && spheres * triangles_of_sphere(divisions) > most) --divisions;
    if (divisions == 3) return;
    sphere_ = make_sphere(divisions);
    source_.approximate(source_.root(), "there are " + std::to_string(spheres) + " spheres: each is made of " +
                                            std::to_string(sphere_.triangles.size()) + " triangles, where few have " +
                                            std::to_string(triangles_of_sphere(3)));
}

/// Members of groups count once for each instance.
std::size_t ShapeReader::spheres_of(pugi::xml_node shape) {
    const std::string_view kind = shape.attribute("type").value();
    if (kind == "sphere") return 1;
    if (kind == "merge") return spheres_in(shape);
    const bool is_instance = kind == "instance";
    return is_instance ? spheres_in(source_.find_if_there(shape.child("ref").attribute("id").value())) : 0;
}

std::size_t ShapeReader::spheres_in(pugi::xml_node group) {
    const auto [place, is_new] = spheres_in_.emplace(group.hash_value(), 0);
    if (is_new)
        for (const pugi::xml_node member : group.children("shape"))
            if (std::string_view(member.attribute("type").value()) == "sphere") ++place->second;
    return place->second;
}

void ShapeReader::read(pugi::xml_node node) {
    Properties p(source_, node);
    const std::string kind = node.attribute("type").value();
    if (kind == "shapegroup") return;  // seen through its instances alone
    if (kind == "instance") return read_instance(p);
    if (kind == "merge") return read_members(p, glm::dmat4(1.0));
    read_one(p, kind, glm::dmat4(1.0), false);
}

void ShapeReader::read_instance(Properties& p) {
    const std::vector<NestedObject> groups = p.take_objects("shape");
    if (groups.size() != 1 || groups[0].type != "shapegroup") p.fail("", "needs a reference to one shapegroup");
    const glm::dmat4 to_world = p.placement("to_world");
    p.finish();
    Properties group(source_, groups[0].node);
    read_members(group, to_world);
}

/// Groups hold no instances (Mitsuba's rule), so this does not recurse.
void ShapeReader::read_members(Properties& group, const glm::dmat4& to_world) {
    for (const NestedObject& member : group.take_objects("shape")) {
        Properties p(source_, member.node);
        if (member.type == "instance" || member.type == "shapegroup" || member.type == "merge")
            p.approximate("", "inside a group is not supported: left out");
        else
            source_.problems().attempt([&] { read_one(p, member.type, to_world, true); });
    }
}

void ShapeReader::read_one(Properties& p, const std::string& kind, const glm::dmat4& group_to_world, bool keep_mesh) {
    if (!is_known_shape(kind)) return p.approximate("", "is not supported: left out");
    Shape shape;
    shape.kind = kind;
    Mesh own;
    const Mesh& mesh = mesh_of(p, kind, keep_mesh, own);
    const std::string ordinal = std::to_string(++ordinals_[kind]), id = p.node().attribute("id").value();
    shape.id = id.empty() ? kind + " " + ordinal : id;
    read_emission(p, shape);
    read_meters(p, shape);
    place(p, mesh, group_to_world, shape, materials_of(p, mesh, shape));
}

/// Files of a group's members are read once for all instances.
const Mesh& ShapeReader::mesh_of(Properties& p, const std::string& kind, bool keep, Mesh& own) {
    if (kind == "sphere") return sphere_;
    if (!keep) return own = read_shape_mesh(p, kind);
    p.ignore({"filename", "flip_tex_coords", "shape_index", "max_smooth_angle", "collapse", "srgb", "load_materials"});
    const auto place = meshes_.find(p.node().hash_value());
    return place != meshes_.end() ? place->second : meshes_[p.node().hash_value()] = read_shape_mesh(p, kind);
}

/// One for the whole mesh, or one for each of its materials.
std::vector<std::uint32_t> ShapeReader::materials_of(Properties& p, const Mesh& mesh, const Shape& shape) {
    const std::vector<NestedObject> bsdfs = p.take_objects("bsdf");
    const bool has_medium = !p.take_objects("medium").empty(), is_old = source_.version(p.node()) < 2;
    if (has_medium) p.approximate("", "has a medium, which is not supported: left out");
    // In Mitsuba 0.x the boundary of a medium is not seen unless a material says so.
    const bool is_unseen = has_medium && !shape.emits && is_old;
    const auto absent = [&] { return is_unseen ? bsdfs_.pass() : default_material(shape.emits); };
    const bool has_names = std::any_of(mesh.materials.begin(), mesh.materials.end(), [](const std::string& name) { return !name.empty(); });
    if (shape.kind == "obj" && is_old && has_names) return materials_by_name(p, mesh, bsdfs, shape.emits, absent);
    return {bsdfs.empty() ? absent() : material_of(p, bsdfs, shape.emits)};
}

/// As Mitsuba 0.x gives an OBJ its materials: first those of its libraries, then the shape's in their order, one without a name to all.
std::vector<std::uint32_t> ShapeReader::materials_by_name(Properties& p, const Mesh& mesh, const std::vector<NestedObject>& bsdfs,
                                                          bool emits, const std::function<std::uint32_t()>& absent) {
    const bool for_all = bsdfs.size() == 1 && !names_one_of(mesh, bsdfs[0]);  // a name that says nothing
    if (!for_all) check_names(mesh, bsdfs);
    const auto is_for = [&](const NestedObject& bsdf, const std::string& name) {
        return for_all || name_of(bsdf).empty() || name_of(bsdf) == name;
    };
    std::map<std::string, pugi::xml_node> libraries;
    if (p.boolean("load_materials", true))
        libraries = mtl_bsdfs_.of(mesh, source_.find_file(p.text("filename", ""), p.node()).parent_path(), p.node());
    std::vector<std::uint32_t> result;
    for (const std::string& name : mesh.materials) {
        const auto own = std::find_if(bsdfs.rbegin(), bsdfs.rend(), [&](const NestedObject& bsdf) { return is_for(bsdf, name); });
        const auto of_library = libraries.find(name);
        if (own != bsdfs.rend()) {
            result.push_back(index_of(p, own->node, own->named_at, emits));
        } else if (of_library != libraries.end()) {
            result.push_back(index_of(p, of_library->second, p.node(), emits));
        } else {
            if (!name.empty()) source_.warn(p.node(), p.label() + ": nothing says what material " + in_quotes(name) + " is: it is grey");
            result.push_back(absent());
        }
    }
    return result;
}

/// Misspelt ones would have no effect.
void ShapeReader::check_names(const Mesh& mesh, const std::vector<NestedObject>& bsdfs) {
    for (const NestedObject& bsdf : bsdfs) {
        if (names_one_of(mesh, bsdf)) continue;
        const std::string close = closest_name(name_of(bsdf), mesh.materials);
        source_.warn(bsdf.named_at, "the mesh has no material " + in_quotes(name_of(bsdf)) + ": ignored" +
                                        (close.empty() ? "" : "; did you mean " + in_quotes(close) + "?"));
    }
}

/// The shape's own.
std::uint32_t ShapeReader::material_of(Properties& p, const std::vector<NestedObject>& bsdfs, bool emits) {
    if (bsdfs.size() > 1 && bsdfs[0].name.empty()) source_.fail(bsdfs[1].named_at, p.label() + " has more than one bsdf");
    if (bsdfs.size() > 1)
        source_.approximate(bsdfs[1].named_at, p.label() + ": materials by names of the mesh are not supported here: the first is used");
    return index_of(p, bsdfs[0].node, bsdfs[0].named_at, emits);
}

std::uint32_t ShapeReader::index_of(Properties& p, pugi::xml_node bsdf, pugi::xml_node named_at, bool emits) {
    const std::uint32_t index = bsdfs_.index_of(bsdf);
    if (!emits || scene_.materials[index].model != MATERIAL_PASS) return index;
    source_.approximate(named_at, p.label() + ": a null material on a light is read as a black one");
    return default_material(true);
}

/// Mitsuba's for shapes that name none: grey, or black if they emit.
std::uint32_t ShapeReader::default_material(bool emits) {
    std::int64_t& index = default_material_[emits ? 1 : 0];
    if (index < 0) {
        SceneMaterial material;
        material.id = emits ? "default (emitter)" : "default";
        if (emits) material.albedo = glm::vec3(0.0F);
        index = bsdfs_.append(std::move(material));
    }
    return static_cast<std::uint32_t>(index);
}

void ShapeReader::read_emission(Properties& p, Shape& shape) {
    for (const NestedObject& object : p.take_objects("emitter")) {
        if (shape.emits) source_.fail(object.named_at, p.label() + " has more than one emitter");
        emitters_.read_area(object, shape);
    }
}

/// A sensor inside a shape measures it.
void ShapeReader::read_meters(Properties& p, const Shape& shape) {
    for (const NestedObject& object : p.take_objects("sensor")) {
        Properties sensor(source_, object.node);
        if (object.type != "irradiancemeter") {
            sensor.approximate("", "inside a shape is not supported: left out");
            continue;
        }
        sensor.take_objects("film");
        sensor.take_objects("sampler");
        sensor.ignore({"shutter_open", "shutter_close", "srf", "sample_count", "to_world"});
        sensor.finish();
        const std::string id = object.node.attribute("id").value();
        scene_.meters.push_back({id.empty() ? shape.id : id, static_cast<std::uint32_t>(scene_.shapes.size())});
    }
}

/// In one piece if it is of one material.
void ShapeReader::place(Properties& p, const Mesh& mesh, const glm::dmat4& group_to_world, const Shape& shape,
                        const std::vector<std::uint32_t>& materials) {
    MeshPlacement placement;
    placement.to_world = group_to_world * shape_to_world(p, shape.kind);
    placement.flip_normals = p.boolean("flip_normals", false);
    placement.face_normals = p.boolean("face_normals", false);
    p.finish();
    for (const std::string& note : mesh.notes) source_.warn(p.node(), p.label() + " " + in_quotes(shape.id) + ": " + note);
    if (std::count(materials.begin(), materials.end(), materials[0]) == static_cast<std::ptrdiff_t>(materials.size()))
        return place_part(p, mesh, placement, shape, materials[0]);
    if (!scene_.meters.empty() && scene_.meters.back().shape == scene_.shapes.size())
        p.approximate("", "has a sensor and several materials: the sensor measures the first of them alone");
    const std::vector<Mesh> parts = parts_of(mesh, mesh.material, materials.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].triangles.empty()) continue;
        Shape part = shape;
        part.id += " " + mesh.materials[i];
        place_part(p, parts[i], placement, std::move(part), materials[i]);
    }
}

void ShapeReader::place_part(Properties& p, const Mesh& mesh, const MeshPlacement& placement, Shape shape, std::uint32_t material) {
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
