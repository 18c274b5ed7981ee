#include "scene/texture_lookup.h"

#include <array>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <memory>

#include "image/colour.h"

namespace pencil {
namespace {

/// All half floats: software conversion of each texel would take longer than the rest of a look-up.
const std::array<float, 65536>& halves() {
    static const auto table = [] {
        auto values = std::make_unique<std::array<float, 65536>>();
        for (std::size_t i = 0; i < values->size(); ++i) (*values)[i] = glm::unpackHalf1x16(static_cast<glm::uint16>(i));
        return values;
    }();
    return *table;
}

int wrap(int i, int size, Texture::Wrap mode) {
    if (mode == Texture::Wrap::clamp) return glm::clamp(i, 0, size - 1);
    const int period = mode == Texture::Wrap::mirror ? 2 * size : size, r = i % period, k = r < 0 ? r + period : r;
    return k < size ? k : period - 1 - k;
}

glm::vec4 texel(const Texture& texture, int x, int y) {
    const std::array<float, 65536>& half = halves();
    const auto column = static_cast<std::size_t>(wrap(x, texture.width, texture.wrap_u)),
               row = static_cast<std::size_t>(wrap(y, texture.height, texture.wrap_v));
    const glm::u16vec4& t = texture.texels[row * static_cast<std::size_t>(texture.width) + column];
    return {half[t.x], half[t.y], half[t.z], half[t.w]};
}

glm::dvec2 transformed(const Texture& texture, const glm::vec2& uv) { return glm::dvec2(texture.to_uv * glm::dvec3(uv, 1.0)); }

/// The four texels about a place, whose centres lie at odd halves.
struct Patch {
    glm::vec4 t00, t10, t01, t11;
    glm::vec2 f;
    Patch(const Texture& texture, const glm::dvec2& uv) {
        const glm::dvec2 p = uv * glm::dvec2(texture.width, texture.height) - 0.5, corner = glm::floor(p);
        f = glm::vec2(p - corner);
        const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
        t00 = texel(texture, x, y);
        t10 = texel(texture, x + 1, y);
        t01 = texel(texture, x, y + 1);
        t11 = texel(texture, x + 1, y + 1);
    }
};

/// Coordinates whose squares fit an int: others have no place in the image.
bool sane(const glm::dvec2& uv, const Texture& texture) {
    const double x = std::abs(uv.x) * texture.width, y = std::abs(uv.y) * texture.height;
    return x < 1e9 && y < 1e9;
}

}  // namespace

glm::vec4 look_up(const Texture& texture, const glm::vec2& uv, const glm::vec3& colour) {
    if (texture.kind == Texture::Kind::vertex_colours) return {colour, 1.0F};
    const glm::dvec2 p = transformed(texture, uv);
    if (texture.kind == Texture::Kind::checkerboard) {
        const glm::dvec2 squares = glm::floor(2.0 * p);
        return {texture.colours[std::fmod(squares.x + squares.y, 2.0) == 0 ? 0 : 1], 1.0F};
    }
    if (texture.texels.empty() || !sane(p, texture)) return glm::vec4(0, 0, 0, 1);
    if (texture.nearest)
        return texel(texture, static_cast<int>(std::floor(p.x * texture.width)), static_cast<int>(std::floor(p.y * texture.height)));
    const Patch patch(texture, p);
    return glm::mix(glm::mix(patch.t00, patch.t10, patch.f.x), glm::mix(patch.t01, patch.t11, patch.f.x), patch.f.y);
}

glm::vec2 look_up_slope(const Texture& texture, const glm::vec2& uv) {
    const glm::dvec2 p = transformed(texture, uv);
    if (texture.kind != Texture::Kind::bitmap || texture.texels.empty() || !sane(p, texture)) return glm::vec2(0.0F);
    const Patch patch(texture, p);
    const auto height = [](const glm::vec4& texel) { return luminance(glm::dvec3(texel)); };
    const double y00 = height(patch.t00), y10 = height(patch.t10), y01 = height(patch.t01), y11 = height(patch.t11);
    const glm::dvec2 f(patch.f),
        slope(texture.width * glm::mix(y10 - y00, y11 - y01, f.y), texture.height * glm::mix(y01 - y00, y11 - y10, f.x));
    const glm::dmat2 inner(texture.to_uv);  // the chain rule: by column, what u and v change
    return glm::vec2(glm::dot(inner[0], slope), glm::dot(inner[1], slope));
}

glm::vec3 mean_colour(const Texture& texture) {
    if (texture.kind == Texture::Kind::checkerboard) return 0.5F * (texture.colours[0] + texture.colours[1]);
    if (texture.kind == Texture::Kind::vertex_colours || texture.texels.empty()) return glm::vec3(1.0F);
    const std::array<float, 65536>& half = halves();
    glm::dvec3 sum(0.0);
    for (const glm::u16vec4& t : texture.texels) sum += glm::dvec3(half[t.x], half[t.y], half[t.z]);
    return glm::vec3(sum / static_cast<double>(texture.texels.size()));
}

glm::dvec3 mean_radiance(const Scene& scene, const Shape& shape) {
    const glm::dvec3 radiance(shape.radiance);
    if (shape.radiance_texture == no_texture) return radiance;
    return radiance * glm::dvec3(mean_colour(scene.textures[static_cast<std::size_t>(shape.radiance_texture)]));
}

}  // namespace pencil
