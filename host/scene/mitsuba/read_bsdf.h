// Mitsuba's materials: the models of bsdf_plugins.h, and those that hold others.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "scene/mitsuba/properties.h"
#include "scene/mitsuba/read_texture.h"
#include "scene/scene.h"

namespace pencil {

class BsdfReader {
public:
    BsdfReader(XmlSource& source, Scene& scene, TextureReader& textures) : source_(source), scene_(scene), textures_(textures) {}

    /// Index into Scene::materials of a <bsdf>, which is appended when it is first asked for, after those that it holds.
    std::uint32_t index_of(pugi::xml_node node) { return index_of(node, 0); }
    /// Reads these for their defects alone. The last thing to do.
    void check(const std::vector<pugi::xml_node>& nodes);
    std::uint32_t append(SceneMaterial material);
    /// Of the material that lets all light through.
    std::uint32_t pass();

private:
    std::uint32_t index_of(pugi::xml_node node, int depth);
    SceneMaterial read(pugi::xml_node node, int depth);
    SceneMaterial read_new(pugi::xml_node node, int depth);
    SceneMaterial read_holder(Properties& p, const std::string& type, int depth);
    SceneMaterial two_sided(Properties& p, int depth);
    SceneMaterial mask(Properties& p, int depth);
    SceneMaterial blend(Properties& p, int depth);
    SceneMaterial mixture(Properties& p, int depth);
    SceneMaterial relief(Properties& p, bool bump, int depth);
    SceneMaterial stand_in(Properties& p, int depth);
    NestedObject only_bsdf(Properties& p);
    int nesting(const SceneMaterial& material);
    void change_leaves(SceneMaterial& material, const std::function<void(SceneMaterial&)>& change);

    XmlSource& source_;
    Scene& scene_;
    TextureReader& textures_;
    std::map<std::size_t, std::uint32_t> indices_;    // by node
    std::map<std::size_t, SceneMaterial> materials_;  // by node
    std::map<std::int64_t, int> nesting_;             // by index
    std::optional<std::uint32_t> pass_;
};

}  // namespace pencil
