#include "scene/gltf/read_texture.h"

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "scene/gltf/gltf_values.h"
#include "scene/scene_file.h"

namespace pencil {
namespace {

constexpr std::size_t max_changed_texels = std::size_t{1} << 28;  // 2 GiB

constexpr const char* transform_extension = "KHR_texture_transform";

/// KHR_texture_transform: scaled, turned, moved. Positive angles turn from +v to +u, since v grows downwards.
glm::dmat3 transform_of(const tinygltf::Value* transform) {
    const double angle = number_of(transform, "rotation", 0), c = std::cos(angle), s = std::sin(angle);
    const double x = element_of(transform, "scale", 0, 1), y = element_of(transform, "scale", 1, 1);
    return {glm::dvec3(c * x, -s * x, 0), glm::dvec3(s * y, c * y, 0),
            glm::dvec3(element_of(transform, "offset", 0, 0), element_of(transform, "offset", 1, 0), 1)};
}

Texture::Wrap wrap_of(int mode) {
    if (mode == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Texture::Wrap::clamp;
    return mode == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT ? Texture::Wrap::mirror : Texture::Wrap::repeat;
}

}  // namespace

int uv_set_of(const tinygltf::TextureInfo& info) {
    return index_of(find_extension(info.extensions, transform_extension), "texCoord", info.texCoord);
}

TextureSampling TextureReader::sampling_of(const tinygltf::TextureInfo& info, const tinygltf::Texture& texture, const std::string& user) {
    TextureSampling sampling;
    if (const tinygltf::Value* transform = find_extension(info.extensions, transform_extension)) sampling.to_uv = transform_of(transform);
    if (texture.sampler < 0) return sampling;
    const tinygltf::Sampler& sampler = file_.at(file_.model().samplers, texture.sampler, "sampler", user);
    sampling.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    sampling.wrap_u = wrap_of(sampler.wrapS);
    sampling.wrap_v = wrap_of(sampler.wrapT);
    return sampling;
}

int TextureReader::add(const tinygltf::TextureInfo& info, const TextureUse& use, int uv_set, const std::string& user) {
    if (info.index < 0) return no_texture;
    const tinygltf::Texture& texture = file_.at(file_.model().textures, info.index, "texture", user);
    if (texture.source < 0) {
        file_.approximate(user + " is left out: it has no image in PNG or JPEG");
        return no_texture;
    }
    if (uv_set_of(info) != uv_set) {
        file_.approximate(
            user + " is laid out by another set of texture coordinates than its material's other textures; the set of the first is " +
            "used");
    }
    const tinygltf::Image& image = file_.at(file_.model().images, texture.source, "image", user);
    if (image.bufferView < 0 && image.image.empty() && !image.uri.empty()) return no_texture;  // told: the file is not there
    const std::string where = shown(file_.path()) + ": " + user, number = std::to_string(texture.source);
    const std::string name = file_.path().string() + " image " + number + (image.uri.empty() ? "" : " " + image.uri);
    const TextureSampling sampling = sampling_of(info, texture, user);
    if (image.bufferView >= 0)
        return add_texture_bytes(scene_, accessors_.bytes(image.bufferView, "image " + number), name, use, where, sampling);
    const std::string_view bytes(reinterpret_cast<const char*>(image.image.data()), image.image.size());
    return add_texture_bytes(scene_, bytes, name, use, where, sampling);
}

int TextureReader::vertex_colours() {
    if (vertex_colours_ != no_texture) return vertex_colours_;
    Texture texture;
    texture.kind = Texture::Kind::vertex_colours;
    texture.name = "colours of vertices";
    scene_.textures.push_back(std::move(texture));
    return vertex_colours_ = static_cast<int>(scene_.textures.size()) - 1;
}

int TextureReader::add_combined(int texture, int other, const std::string& change,
                                const std::function<glm::vec4(const glm::vec4&, const glm::vec4&)>& changed) {
    const glm::vec4 white(1.0F);
    if (texture == no_texture) return add_changed(other, change, [&](const glm::vec4& texel) { return changed(white, texel); });
    if (other == no_texture) return add_changed(texture, change, [&](const glm::vec4& texel) { return changed(texel, white); });
    const Texture with = scene_.textures[static_cast<std::size_t>(other)];  // a copy: others are added
    const int width = scene_.textures[static_cast<std::size_t>(texture)].width,
              height = scene_.textures[static_cast<std::size_t>(texture)].height;
    std::size_t number = 0;  // texels are asked for row by row
    return add_changed(texture, change + " " + std::to_string(other), [&](const glm::vec4& texel) {
        const std::size_t x = number % static_cast<std::size_t>(width), y = number / static_cast<std::size_t>(width);
        ++number;
        const std::size_t at =
            y * static_cast<std::size_t>(with.height) / static_cast<std::size_t>(height) * static_cast<std::size_t>(with.width) +
            x * static_cast<std::size_t>(with.width) / static_cast<std::size_t>(width);
        return changed(texel, glm::unpackHalf(with.texels[at]));
    });
}

int TextureReader::add_changed(int texture, const std::string& change, const std::function<glm::vec4(const glm::vec4&)>& changed) {
    const auto [place, is_new] = changed_.emplace(std::pair(texture, change), static_cast<int>(scene_.textures.size()));
    if (!is_new) return place->second;
    Texture copy = scene_.textures[static_cast<std::size_t>(texture)];
    std::size_t total = copy.texels.size();
    for (const auto& [key, index] : changed_)
        if (index != place->second) total += scene_.textures[static_cast<std::size_t>(index)].texels.size();
    if (total > max_changed_texels)
        file_.fail("the textures that must be changed have more than " + std::to_string(max_changed_texels) + " pixels");
    copy.name += ", " + change;
    for (glm::u16vec4& texel : copy.texels) texel = glm::packHalf(changed(glm::unpackHalf(texel)));
    scene_.textures.push_back(std::move(copy));
    return place->second;
}

}  // namespace pencil
