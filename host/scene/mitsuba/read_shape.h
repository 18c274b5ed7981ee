// Mitsuba's shapes: built-in ones and meshes from files, each with its material and perhaps an emitter.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "scene/meshes/mesh.h"
#include "scene/mitsuba/properties.h"
#include "scene/scene.h"

namespace pencil {

/// Materials are added to the scene when a shape first uses them.
class ShapeReader {
public:
    ShapeReader(XmlSource& source, Scene& scene) : source_(source), scene_(scene) {}

    /// Appends the shape to the scene.
    void read(pugi::xml_node node);

private:
    std::uint32_t material_of(Properties& p, bool emits);
    std::uint32_t add_material(SceneMaterial material);
    void read_emission(Properties& p, Shape& shape);
    Mesh read_mesh(Properties& p, const std::string& kind);
    glm::dmat4 object_to_world(Properties& p, const std::string& kind);
    void place(Properties& p, const Mesh& mesh, Shape shape, std::uint32_t material);

    XmlSource& source_;
    Scene& scene_;
    std::map<std::size_t, std::uint32_t> materials_;  // by node
    std::int64_t default_material_[2] = {-1, -1};
    std::map<std::string, int> ordinals_;
};

}  // namespace pencil
