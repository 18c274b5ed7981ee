// Mitsuba's shapes, each with its material and perhaps an emitter, and groups of shapes with their instances.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scene/meshes/mesh.h"
#include "scene/mitsuba/mtl_bsdfs.h"
#include "scene/mitsuba/properties.h"
#include "scene/mitsuba/read_bsdf.h"
#include "scene/mitsuba/read_emitter.h"
#include "scene/scene.h"

namespace pencil {

/// Materials are added to the scene when a shape first uses them.
class ShapeReader {
public:
    ShapeReader(XmlSource& source, Scene& scene, BsdfReader& bsdfs, EmitterReader& emitters)
        : source_(source), scene_(scene), bsdfs_(bsdfs), emitters_(emitters), mtl_bsdfs_(source) {}

    /// Before any is read: what the scene's elements will be. Thousands of spheres are made of fewer triangles each, and a warning says so.
    void expect(const std::vector<pugi::xml_node>& nodes);
    /// Appends the shape to the scene: its copies, if it is an instance of a group; nothing, if it is a group.
    void read(pugi::xml_node node);

private:
    std::size_t spheres_of(pugi::xml_node shape);
    std::size_t spheres_in(pugi::xml_node group);
    void read_one(Properties& p, const std::string& kind, const glm::dmat4& group_to_world, bool keep_mesh);
    void read_instance(Properties& p);
    void read_members(Properties& group, const glm::dmat4& to_world);
    const Mesh& mesh_of(Properties& p, const std::string& kind, bool keep, Mesh& own);
    std::vector<std::uint32_t> materials_of(Properties& p, const Mesh& mesh, const Shape& shape);
    std::vector<std::uint32_t> materials_by_name(Properties& p, const Mesh& mesh, const std::vector<NestedObject>& bsdfs, bool emits,
                                                 const std::function<std::uint32_t()>& absent);
    void check_names(const Mesh& mesh, const std::vector<NestedObject>& bsdfs);
    std::uint32_t material_of(Properties& p, const std::vector<NestedObject>& bsdfs, bool emits);
    std::uint32_t index_of(Properties& p, pugi::xml_node bsdf, pugi::xml_node named_at, bool emits);
    std::uint32_t default_material(bool emits);
    void read_emission(Properties& p, Shape& shape);
    void read_meters(Properties& p, const Shape& shape);
    void place(Properties& p, const Mesh& mesh, const glm::dmat4& group_to_world, const Shape& shape,
               const std::vector<std::uint32_t>& materials);
    void place_part(Properties& p, const Mesh& mesh, const MeshPlacement& placement, Shape shape, std::uint32_t material);

    XmlSource& source_;
    Scene& scene_;
    BsdfReader& bsdfs_;
    EmitterReader& emitters_;
    MtlBsdfs mtl_bsdfs_;
    Mesh sphere_ = make_sphere(3);
    std::map<std::size_t, std::size_t> spheres_in_;  // groups, by node
    std::map<std::size_t, Mesh> meshes_;             // of groups' members, by node
    std::int64_t default_material_[2] = {-1, -1};
    std::map<std::string, int> ordinals_;
};

}  // namespace pencil
