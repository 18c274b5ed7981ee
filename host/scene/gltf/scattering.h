// How a glTF material scatters light, opacity aside: metallic-roughness with its extensions, as models of a SceneMaterial.
#pragma once

#include <string>

#include "scene/gltf/gltf_file.h"
#include "scene/gltf/read_texture.h"
#include "scene/scene.h"

namespace pencil {

class Scattering {
public:
    /// `label` names the material in messages.
    Scattering(GltfFile& file, TextureReader& textures, const tinygltf::Material& material, int uv_set, std::string label)
        : file_(file), textures_(textures), material_(material), uv_set_(uv_set), label_(std::move(label)) {}

    /// A material that reflects, by Disney's principled model, or diffusely if it is unlit.
    SceneMaterial reflecting();
    /// Whether light goes through it, and how much of what no metal reflects.
    bool transmits() const { return transmission() > 0; }
    double transmission() const;
    /// The texture of this share, in its red channel.
    int transmission_texture();
    /// A material that transmits all light that it does not reflect.
    SceneMaterial transmitting();

private:
    const tinygltf::Value* extension(const char* name) const;
    int texture(const tinygltf::TextureInfo& info, const TextureUse& use, const char* what);
    void base_colour(SceneMaterial& result);
    void specular_glossiness(const tinygltf::Value& glossy, SceneMaterial& result);
    void coats(SceneMaterial& result);
    void relief(SceneMaterial& result);
    double index_of_refraction() const;
    /// With the strength of KHR_materials_specular.
    double effective_index() const;
    void leave_out_textures(const char* extension_name, std::initializer_list<const char*> names);

    GltfFile& file_;
    TextureReader& textures_;
    const tinygltf::Material& material_;
    int uv_set_;
    std::string label_;
};

}  // namespace pencil
