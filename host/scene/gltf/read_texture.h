// Textures of a glTF file: an image, how it is sampled, and how coordinates are transformed.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "scene/gltf/accessor.h"
#include "scene/scene.h"
#include "scene/textures/add_texture.h"

namespace pencil {

class TextureReader {
public:
    TextureReader(GltfFile& file, Scene& scene) : file_(file), accessors_(file), scene_(scene) {}

    /// Index into Scene::textures, or no_texture where `info` names none, or one whose image is in a format of an extension. `user` names
    /// the texture in messages; it is laid out by set `uv_set` of texture coordinates.
    int add(const tinygltf::TextureInfo& info, const TextureUse& use, int uv_set, const std::string& user);

    /// A copy of a texture with every texel changed; `change` names the change and its numbers.
    int add_changed(int texture, const std::string& change, const std::function<glm::vec4(const glm::vec4&)>& changed);

    /// A texture laid out as `texture`, with every texel changed by that of `other` at the same place; either may be no_texture, which is white
    /// everywhere, but not both.
    int add_combined(int texture, int other, const std::string& change,
                     const std::function<glm::vec4(const glm::vec4&, const glm::vec4&)>& changed);

    /// The texture of Scene::colours.
    int vertex_colours();

private:
    TextureSampling sampling_of(const tinygltf::TextureInfo& info, const tinygltf::Texture& texture, const std::string& user);

    GltfFile& file_;
    AccessorReader accessors_;
    Scene& scene_;
    std::map<std::pair<int, std::string>, int> changed_;
    int vertex_colours_ = no_texture;
};

/// The set of texture coordinates that a texture is laid out by.
int uv_set_of(const tinygltf::TextureInfo& info);

}  // namespace pencil
