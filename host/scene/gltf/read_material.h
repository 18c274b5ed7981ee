// Materials of a glTF file, as far as they go into a SceneMaterial and the emission of a shape.
#pragma once

#include <map>
#include <utility>

#include "scene/gltf/gltf_file.h"
#include "scene/gltf/read_texture.h"
#include "scene/gltf/scattering.h"
#include "scene/scene.h"

namespace pencil {

class MaterialReader {
public:
    MaterialReader(GltfFile& file, Scene& scene) : file_(file), scene_(scene), textures_(file, scene) {}

    /// Index into Scene::materials; the glTF material -1 is glTF's default one. With `vertex_colours` they are its base colour, unless it
    /// has a texture for that.
    std::uint32_t read(int material, bool vertex_colours);
    /// What shapes of the material emit.
    void read_emission(int material, Shape& shape);
    /// The set of texture coordinates of the material's textures.
    int uv_set(int material) const;

private:
    const tinygltf::Material& at(int material) const;
    std::string label(int material) const;
    std::int64_t add(const SceneMaterial& material);
    SceneMaterial partly_transmitting(const SceneMaterial& reflecting, Scattering& scattering);
    SceneMaterial partly_covering(SceneMaterial result, const tinygltf::Material& material, int texture);
    /// The second with the probability `weight`, times a texture; appends both.
    SceneMaterial blend(const SceneMaterial& first, const SceneMaterial& second, float weight, int texture);
    bool is_opaque(int texture) const;

    GltfFile& file_;
    Scene& scene_;
    TextureReader textures_;
    tinygltf::Material default_;
    std::map<std::pair<int, bool>, std::uint32_t> read_;
    std::int64_t pass_ = -1;
};

}  // namespace pencil
