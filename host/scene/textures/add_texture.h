// Bitmaps of a scene, from files or from bytes inside other files, for readers of all formats.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace pencil {

/// What a picture's numbers are for.
struct TextureUse {
    enum class Channel { all, luminance, red, green, blue, opacity };
    /// Of integer values: 0 decodes them by the sRGB curve, 1 takes them as they are (Mitsuba's "raw"), another exponent as a power law.
    /// Floating-point files are linear in any case.
    double gamma = 0;
    Channel channel = Channel::all;  // the number that takes the place of red, green and blue: for weights, roughness and heights
};

constexpr TextureUse colour_use{}, raw_use{1.0, TextureUse::Channel::all};

/// How it is laid over a surface.
struct TextureSampling {
    glm::dmat3 to_uv{1.0};
    bool nearest = false;
    Texture::Wrap wrap_u = Texture::Wrap::repeat, wrap_v = Texture::Wrap::repeat;
};

/// Index into Scene::textures. The same file for the same use and sampling is one texture; for other sampling its texels are copied, not
/// decoded again. SceneError at `where` as by decode_image_file.
int add_texture_file(Scene& scene, const std::filesystem::path& file, const TextureUse& use, const std::string& where,
                     const TextureSampling& sampling = {});

/// The same of the bytes of a PNG, JPEG, ... file. `name` must tell the scene's pictures apart.
int add_texture_bytes(Scene& scene, std::string_view bytes, const std::string& name, const TextureUse& use, const std::string& where,
                      const TextureSampling& sampling = {});

}  // namespace pencil
