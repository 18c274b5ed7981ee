// From the checked XML tree to a Scene. Shapes refer to their materials by index; a material is added when a shape first uses it, but
// every one in the file is read, so that a mistake shows even where nothing uses it yet.
#include "scene/mitsuba/load_scene.h"

#include <new>

#include "scene/meshes/mesh.h"
#include "scene/mitsuba/properties.h"
#include "scene/mitsuba/read_bsdf.h"
#include "scene/mitsuba/read_integrator.h"
#include "scene/meshes/read_obj.h"
#include "scene/meshes/read_ply.h"
#include "scene/mitsuba/read_sensor.h"
#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

class SceneReader {
public:
    explicit SceneReader(XmlSource& source) : source_(source) { scene_.file = source.file().string(); }

    Scene read() {
        for (const pugi::xml_node node : source_.root().children()) top_level(node);
        if (!has_sensor_) throw SceneError(shown(source_.file()), "the scene has no sensor; add <sensor type=\"perspective\">");
        scene_.warnings = source_.warnings();
        return std::move(scene_);
    }

private:
    void top_level(pugi::xml_node node) {
        const std::string tag = node.name();
        if (tag == "default" || tag == "alias") return;
        if (tag == "integrator") return integrator(node);
        if (tag == "sensor") return sensor(node);
        if (tag == "bsdf") return (void)read_bsdf(source_, node);
        if (tag == "shape") return shape(node);
        if (tag == "emitter") return emitter(node);
        const bool plugin = tag == "texture" || tag == "medium" || tag == "volume" || tag == "phase";
        source_.fail(node, "<" + tag + "> " + (plugin ? "is not supported" : "cannot stand directly inside <scene>"));
    }

    void integrator(pugi::xml_node node) {
        if (has_integrator_) source_.fail(node, "the scene has more than one integrator");
        has_integrator_ = true;
        scene_.max_depth = read_max_depth(source_, node);
    }

    void sensor(pugi::xml_node node) {
        const PerspectiveSensor sensor = read_sensor(source_, node);
        if (has_sensor_) return source_.warn(node, "the scene has more than one sensor; the first is used");
        has_sensor_ = true;
        scene_.sensor = sensor;
    }

    std::uint32_t bsdf_index(pugi::xml_node node) {
        const auto place = bsdfs_.find(node.hash_value());
        if (place != bsdfs_.end()) return place->second;
        return bsdfs_[node.hash_value()] = add_bsdf(read_bsdf(source_, node));
    }

    std::uint32_t add_bsdf(Diffuse bsdf) {
        scene_.bsdfs.push_back(std::move(bsdf));
        return static_cast<std::uint32_t>(scene_.bsdfs.size() - 1);
    }

    /// Mitsuba's material for shapes that name none: grey, or black if they emit.
    std::uint32_t default_bsdf(bool emits) {
        std::int64_t& index = default_bsdf_[emits ? 1 : 0];
        if (index < 0) index = add_bsdf({emits ? "default (emitter)" : "default", glm::vec3(emits ? 0.0F : 0.5F), false});
        return static_cast<std::uint32_t>(index);
    }

    void emitter(pugi::xml_node node) {
        Properties p(source_, node);
        const std::string type = node.attribute("type").value();
        if (type == "area") source_.fail(node, p.label() + " must stand inside the shape that emits");
        if (type != "point") source_.fail(node, p.label() + " is not supported; supported: point, and area inside a shape");
        if (p.has("position") && p.has("to_world")) p.fail("position", "give either position or to_world, not both");
        PointLight light;
        light.position = p.vector("position", glm::dvec3(p.transform("to_world")[3]));
        light.intensity = p.colour("intensity", glm::vec3(1.0F), ColourUse::emission);
        if (!p.objects().empty()) p.fail_nested(p.objects()[0]);
        p.ignore({"sampling_weight"});
        p.finish();
        scene_.point_lights.push_back(light);
    }

    glm::vec3 read_radiance(const NestedObject& object) {
        Properties p(source_, object.node);
        if (object.type != "area") source_.fail(object.named_at, p.label() + " cannot stand inside a shape; supported there: area");
        const glm::vec3 radiance = p.colour("radiance", glm::vec3(1.0F), ColourUse::emission);
        if (!p.objects().empty()) p.fail_nested(p.objects()[0]);
        p.ignore({"sampling_weight"});
        p.finish();
        return radiance;
    }

    void shape(pugi::xml_node node) {
        Properties p(source_, node);
        Shape shape;
        shape.kind = node.attribute("type").value();
        const Mesh mesh = read_mesh(p, shape.kind);
        const std::string ordinal = std::to_string(++ordinals_[shape.kind]);
        shape.id = node.attribute("id") ? std::string(node.attribute("id").value()) : shape.kind + " " + ordinal;
        bool has_bsdf = false;
        for (const NestedObject& object : p.objects()) {
            if (object.kind == "bsdf") {
                if (has_bsdf) source_.fail(object.named_at, p.label() + " has more than one bsdf");
                shape.bsdf = bsdf_index(object.node);
                has_bsdf = true;
            } else if (object.kind == "emitter") {
                if (shape.emits) source_.fail(object.named_at, p.label() + " has more than one emitter");
                shape.radiance = read_radiance(object);
                shape.emits = true;
            } else {
                p.fail_nested(object);
            }
        }
        if (!has_bsdf) shape.bsdf = default_bsdf(shape.emits);
        place(p, mesh, shape);
    }

    Mesh read_mesh(Properties& p, const std::string& kind) {
        if (kind == "rectangle") return make_rectangle();
        if (kind == "cube") return make_cube();
        if (kind == "sphere") return make_sphere();
        if (kind != "obj" && kind != "ply") {
            source_.fail(p.node(), p.label() + " is not supported; supported: rectangle, cube, sphere, obj, ply");
        }
        p.ignore({"flip_tex_coords", "max_smooth_angle", "collapse", "srgb"});
        const std::string name = p.text("filename", "");
        if (!p.has("filename")) p.fail("", "needs a filename");
        const std::string where = source_.where(p.node());
        const std::filesystem::path file = path_inside(source_.file().parent_path(), name, where);
        const std::string bytes = read_regular_file(file, max_mesh_bytes, where);
        return kind == "obj" ? read_obj(bytes, shown(file)) : read_ply(bytes, shown(file));
    }

    /// The sphere's own centre and radius come before to_world.
    glm::dmat4 object_to_world(Properties& p, const std::string& kind) {
        const glm::dmat4 to_world = p.transform("to_world");
        if (kind != "sphere") return to_world;
        const glm::dvec3 center = p.vector("center", glm::dvec3(0.0));
        const double radius = p.number("radius", 1.0);
        if (!(radius > 0.0)) p.fail("radius", "radius must be positive");
        return to_world * glm::dmat4(radius, 0, 0, 0, 0, radius, 0, 0, 0, 0, radius, 0, center.x, center.y, center.z, 1);
    }

    void place(Properties& p, const Mesh& mesh, Shape shape) {
        Placement placement;
        placement.to_world = object_to_world(p, shape.kind);
        placement.flip_normals = p.boolean("flip_normals", false);
        placement.face_normals = p.boolean("face_normals", false);
        p.finish();
        shape.first_triangle = static_cast<std::uint32_t>(scene_.triangles.size());
        const auto number = static_cast<std::uint32_t>(scene_.shapes.size());
        const PlacementCounts counts = place_mesh(mesh, placement, number, source_.where(p.node()), scene_);
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

    XmlSource& source_;
    Scene scene_;
    bool has_integrator_ = false, has_sensor_ = false;
    std::map<std::size_t, std::uint32_t> bsdfs_;  // by node
    std::int64_t default_bsdf_[2] = {-1, -1};
    std::map<std::string, int> ordinals_;
};

}  // namespace

Scene load_scene(const std::filesystem::path& file, const LoadOptions& options) {
    const std::string extension = file.extension().string();
    if (extension == ".obj" || extension == ".ply") {
        throw SceneError(shown(file),
                         "a mesh alone has no camera and no light; name it in a scene: <shape type=\"" + extension.substr(1) + "\">");
    }
    try {
        XmlSource source(file, options.defines);
        return SceneReader(source).read();
    } catch (const std::bad_alloc&) {
        throw MemoryError("reading " + shown(file) + " needs more memory than there is");
    }
}

}  // namespace pencil
