#include "scene/models/read_model.h"

#include <map>
#include <utility>

#include "scene/default_view.h"
#include "scene/file_search.h"
#include "scene/meshes/mesh_parts.h"
#include "scene/meshes/read_mtl.h"
#include "scene/meshes/read_obj.h"
#include "scene/meshes/read_ply.h"
#include "scene/models/mtl_scattering.h"
#include "scene/problems.h"
#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

class ModelReader {
public:
    ModelReader(const std::filesystem::path& file, const LoadOptions& options)
        : file_(file), where_(shown(file)), problems_(options.strict), search_(file.parent_path(), options.allowed, problems_) {
        scene_.file = file.string();
    }

    Scene read_obj() {
        Mesh obj = read_obj_file(read_regular_file(file_, max_mesh_bytes, where_), where_);
        for (glm::vec2& uv : obj.uvs) uv.y = 1.0F - uv.y;  // v grows upwards in OBJ
        for (const std::string& library : obj.libraries) read_library(library);
        const std::vector<Mesh> parts = parts_of(obj, obj.material, obj.materials.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (!parts[i].triangles.empty()) add_part(parts[i], obj.materials[i]);
        return finish(obj);
    }

    Scene read_ply() {
        Mesh mesh = pencil::read_ply(read_regular_file(file_, max_mesh_bytes, where_), where_);
        Shape shape;
        shape.id = shape.kind = "ply";
        place(mesh, std::move(shape), coloured(unnamed_material(), mesh));
        return finish(mesh);
    }

private:
    /// Files of the web often lack theirs, or name those of another machine.
    void read_library(const std::string& name) {
        try {
            const std::filesystem::path file = search_.find(name, file_.parent_path(), where_);
            std::vector<SceneError> defects;
            for (MtlMaterial& material : read_mtl(read_regular_file(file, max_mtl_bytes, where_), shown(file), defects))
                library_.emplace(material.name, std::move(material));
            for (const SceneError& defect : defects) leave_out(defect, "; the line is left out", where_, problems_);
        } catch (const SceneError& error) {
            leave_out(error, "; its materials are left out", where_, problems_);
        }
    }

    void add_part(const Mesh& mesh, const std::string& name) {
        const auto material = library_.find(name);
        Shape shape;
        shape.id = name.empty() ? "obj" : name;
        shape.kind = "obj";
        if (material == library_.end()) {
            if (!name.empty()) problems_.approximate(where_, "material " + in_quotes(name) + " is in no library that was read; it is grey");
            return place(mesh, std::move(shape), coloured(unnamed_material(), mesh));
        }
        const MtlContext context{search_, file_.parent_path(), where_, problems_};
        set_mtl_emission(material->second, context, scene_, shape);
        if (!mesh.colours.empty()) problems_.approximate(where_, "colours of vertices are left out where there is a material");
        place(mesh, std::move(shape), add_mtl_material(material->second, context, scene_));
    }

    /// Appends the material; its colour is that of the mesh's vertices if they have any.
    std::uint32_t coloured(SceneMaterial material, const Mesh& mesh) {
        if (!mesh.colours.empty()) {
            Texture texture;
            texture.kind = Texture::Kind::vertex_colours;
            texture.name = "colours of vertices";
            material.albedo = glm::vec3(1.0F);
            material.albedo_texture = static_cast<int>(scene_.textures.size());
            scene_.textures.push_back(std::move(texture));
        }
        scene_.materials.push_back(std::move(material));
        return static_cast<std::uint32_t>(scene_.materials.size() - 1);
    }

    void place(const Mesh& mesh, Shape shape, std::uint32_t material) {
        shape.first_triangle = static_cast<std::uint32_t>(scene_.triangles.size());
        const PlacementCounts counts = place_mesh(mesh, {}, {static_cast<std::uint32_t>(scene_.shapes.size()), material}, where_, scene_);
        dropped_ += counts.dropped;
        turned_ += counts.turned;
        shape.triangle_count = static_cast<std::uint32_t>(scene_.triangles.size()) - shape.first_triangle;
        if (shape.triangle_count > 0) scene_.shapes.push_back(std::move(shape));
    }

    Scene finish(const Mesh& mesh) {
        if (scene_.triangles.empty()) throw SceneError(where_, "the file has no faces: there is nothing to see");
        for (const std::string& note : mesh.notes) problems_.approximate(where_, note);
        if (dropped_ > 0) problems_.warn(where_, std::to_string(dropped_) + " triangles of zero area left out");
        if (turned_ > 0) {
            problems_.warn(
                where_, std::to_string(turned_) + " triangles wound against their vertex normals; the normals say which side is the front");
        }
        problems_.throw_errors();
        scene_.warnings = problems_.warnings();
        complete_scene(scene_, false, where_);
        return std::move(scene_);
    }

    const std::filesystem::path& file_;
    std::string where_;
    Problems problems_;
    FileSearch search_;
    Scene scene_;
    std::map<std::string, MtlMaterial> library_;
    std::size_t dropped_ = 0, turned_ = 0;
};

}  // namespace

Scene read_obj_scene(const std::filesystem::path& file, const LoadOptions& options) { return ModelReader(file, options).read_obj(); }

Scene read_ply_scene(const std::filesystem::path& file, const LoadOptions& options) { return ModelReader(file, options).read_ply(); }

}  // namespace pencil
