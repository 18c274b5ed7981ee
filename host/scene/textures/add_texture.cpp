// A texture's name holds the file and the use, and so tells what is there already.
#include "scene/textures/add_texture.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "scene/textures/decode_image.h"
#include "scene/textures/texel_values.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr std::uint64_t max_scene_texels = std::uint64_t{1} << 29;  // 4 GiB
constexpr float largest_half = 65504.0F;

std::string name_of(const std::string& source, const TextureUse& use) {
    const char* const channels[] = {"", ", luminance", ", red", ", green", ", blue", ", opacity"};
    std::string name = source;
    if (use.gamma == 1)
        name += ", raw";
    else if (use.gamma != 0)
        name += ", gamma " + std::to_string(use.gamma);
    return name + channels[static_cast<int>(use.channel)];
}

std::vector<glm::u16vec4> to_texels(const DecodedImage& image, const TextureUse& use) {
    const TexelValues values(image, use);
    std::vector<glm::u16vec4> texels;
    texels.reserve(image.texels.size());
    for (const glm::vec4& texel : image.texels)
        texels.push_back(glm::packHalf(glm::clamp(values.linear(texel), -largest_half, largest_half)));
    return texels;
}

bool same_sampling(const Texture& texture, const TextureSampling& sampling) {
    return texture.to_uv == sampling.to_uv && texture.nearest == sampling.nearest && texture.wrap_u == sampling.wrap_u &&
           texture.wrap_v == sampling.wrap_v;
}

int append(Scene& scene, Texture texture, const TextureSampling& sampling, const std::string& where) {
    std::uint64_t total = texture.texels.size();
    for (const Texture& other : scene.textures) total += other.texels.size();
    if (total > max_scene_texels)
        throw SceneError(where, "the scene's pictures have more than " + std::to_string(max_scene_texels) + " pixels");
    texture.to_uv = sampling.to_uv;
    texture.nearest = sampling.nearest;
    texture.wrap_u = sampling.wrap_u;
    texture.wrap_v = sampling.wrap_v;
    scene.textures.push_back(std::move(texture));
    return static_cast<int>(scene.textures.size()) - 1;
}

template <class Decode>
int add(Scene& scene, const std::string& name, const TextureUse& use, const TextureSampling& sampling, const std::string& where,
        const Decode& decode) {
    const Texture* same_texels = nullptr;
    for (const Texture& texture : scene.textures) {
        if (texture.kind != Texture::Kind::bitmap || texture.name != name) continue;
        if (same_sampling(texture, sampling)) return static_cast<int>(&texture - scene.textures.data());
        same_texels = &texture;
    }
    if (same_texels) return append(scene, *same_texels, sampling, where);
    const DecodedImage image = decode();
    Texture texture;
    texture.name = name;
    texture.width = image.width;
    texture.height = image.height;
    texture.texels = to_texels(image, use);
    return append(scene, std::move(texture), sampling, where);
}

}  // namespace

int add_texture_file(Scene& scene, const std::filesystem::path& file, const TextureUse& use, const std::string& where,
                     const TextureSampling& sampling) {
    return add(
        scene, name_of(file.string(), use), use, sampling, where, [&] { return decode_image_file(file, where); });
}

int add_texture_bytes(Scene& scene, std::string_view bytes, const std::string& name, const TextureUse& use, const std::string& where,
                      const TextureSampling& sampling) {
    return add(
        scene, name_of(name, use), use, sampling, where, [&] { return decode_image_bytes(bytes, name, where); });
}

}  // namespace pencil
