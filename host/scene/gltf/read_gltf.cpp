// From the nodes of the parsed file to a Scene: each primitive of each node's mesh is a shape.
#include "scene/gltf/read_gltf.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/default_view.h"
#include "scene/gltf/gltf_container.h"
#include "scene/gltf/gltf_values.h"
#include "scene/gltf/node_tree.h"
#include "scene/gltf/read_camera.h"
#include "scene/gltf/read_light.h"
#include "scene/gltf/read_material.h"
#include "scene/gltf/read_primitive.h"
#include "scene/scene_file.h"
#include "scene/text.h"

namespace pencil {
namespace {

class GltfReader {
public:
    GltfReader(const std::filesystem::path& path, const LoadOptions& options) : file_(path, options), materials_(file_, scene_) {
        scene_.file = path.string();
    }

    Scene read() {
        if (!file_.model().animations.empty()) file_.approximate("animations are left out: the scene stands as it is at rest");
        if (file_.model().scenes.size() > 1) file_.warn("the file has more than one scene; its default one is read, or else the first");
        visit_nodes(file_, [this](std::size_t index, const glm::dmat4& to_world) { node(index, to_world); });
        if (scene_.triangles.empty()) file_.fail("the scene has no triangles");
        scene_.warnings = file_.warnings();
        complete_scene(scene_, has_sensor_, shown(file_.path()));
        return std::move(scene_);
    }

private:
    void node(std::size_t index, const glm::dmat4& to_world) {
        const tinygltf::Node& node = file_.model().nodes[index];
        const std::string label = named("node", index, node.name);
        if (node.camera >= 0) camera(node.camera, to_world, label);
        const int light = index_of(find_extension(node.extensions, "KHR_lights_punctual"), "light");
        if (light >= 0) read_light(file_, light, to_world, label, scene_);
        if (node.skin >= 0) file_.approximate("skins are left out: meshes stand as they are at rest");
        if (node.mesh >= 0) mesh(node, to_world, label);
    }

    void camera(int index, const glm::dmat4& to_world, const std::string& label) {
        const PerspectiveSensor sensor = read_camera(file_, index, to_world, label);
        if (has_sensor_) return file_.warn("the scene has more than one camera; the first is used");
        has_sensor_ = true;
        scene_.sensor = sensor;
    }

    void mesh(const tinygltf::Node& node, const glm::dmat4& to_world, const std::string& user) {
        const tinygltf::Mesh& mesh = file_.at(file_.model().meshes, node.mesh, "mesh", user);
        const std::string label = named("mesh", static_cast<std::size_t>(node.mesh), mesh.name);
        const std::string id = !node.name.empty() ? node.name : !mesh.name.empty() ? mesh.name : "mesh " + std::to_string(node.mesh);
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            const bool alone = mesh.primitives.size() == 1;
            const std::string number = std::to_string(i);
            primitive(mesh.primitives[i], to_world, alone ? id : fmt::format("{} {}", id, number),
                      alone ? label : fmt::format("{} primitive {}", label, number));
        }
    }

    void primitive(const tinygltf::Primitive& primitive, const glm::dmat4& to_world, const std::string& id, const std::string& label) {
        const Mesh mesh = read_primitive(file_, primitive, materials_.uv_set(primitive.material), label);
        if (mesh.triangles.empty()) return;
        Shape shape;
        shape.id = id;
        shape.kind = "gltf";
        shape.first_triangle = static_cast<std::uint32_t>(scene_.triangles.size());
        materials_.read_emission(primitive.material, shape);
        const Owner owner{static_cast<std::uint32_t>(scene_.shapes.size()), materials_.read(primitive.material, !mesh.colours.empty())};
        MeshPlacement placement;
        placement.to_world = to_world;
        const std::string where = shown(file_.path()) + ": " + label;
        const PlacementCounts counts = place_mesh(mesh, placement, owner, where, scene_);
        if (counts.dropped > 0) file_.warn(label + ": " + std::to_string(counts.dropped) + " triangles of zero area left out");
        if (counts.turned > 0) {
            file_.warn(label + ": " + std::to_string(counts.turned) +
                       " triangles wound against their vertex normals; the normals say which side is the front");
        }
        shape.triangle_count = static_cast<std::uint32_t>(scene_.triangles.size()) - shape.first_triangle;
        if (shape.triangle_count > 0) scene_.shapes.push_back(std::move(shape));
    }

    GltfFile file_;
    Scene scene_;
    MaterialReader materials_;
    bool has_sensor_ = false;
};

}  // namespace

bool is_gltf(std::string_view head) {
    if (is_glb(head)) return true;
    const std::string_view text = trimmed(head);
    constexpr std::string_view keys[] = {"\"asset\"", "\"accessors\"", "\"bufferViews\"", "\"meshes\""};
    return text.substr(0, 1) == "{" &&
           std::any_of(std::begin(keys), std::end(keys), [&](std::string_view key) { return text.find(key) != std::string_view::npos; });
}

Scene read_gltf(const std::filesystem::path& file, const LoadOptions& options) { return GltfReader(file, options).read(); }

}  // namespace pencil
