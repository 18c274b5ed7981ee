#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "scene/mitsuba/bsdf_plugins.h"

namespace pencil {
namespace {

/// Of a colour times a texture, each component by itself.
glm::vec3 largest_of(const glm::vec3& colour, int index, const Scene& scene) {
    if (index == no_texture) return colour;
    const Texture& texture = scene.textures[static_cast<std::size_t>(index)];
    if (texture.kind == Texture::Kind::checkerboard) return colour * glm::max(texture.colours[0], texture.colours[1]);
    if (texture.texels.empty()) return colour;
    glm::vec3 largest(0.0F);
    for (const glm::u16vec4& texel : texture.texels) largest = glm::max(largest, glm::vec3(glm::unpackHalf(texel)));
    return colour * largest;
}

/// Both parts are scaled where they reflect more than all (Mitsuba 0.x, BSDF::ensureEnergyConservation).
void conserve_energy(Properties& p, const TextureReader& textures, SceneMaterial& material) {
    if (!p.boolean("ensure_energy_conservation", true)) return;
    const glm::vec3 sum = largest_of(material.albedo, material.albedo_texture, textures.scene()) +
                          largest_of(material.specular, material.specular_texture, textures.scene());
    const float largest = std::max({sum.x, sum.y, sum.z});
    if (!(largest > 1.0F)) return;
    const float scale = 0.99F / largest;
    material.albedo *= scale;
    material.specular *= scale;
    p.source().warn(p.node(), p.label() + " reflects more light than it receives: both its parts are scaled by " + std::to_string(scale) +
                                  ", as in Mitsuba 0.x");
}

}  // namespace

SceneMaterial read_plastic(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    material.model = MATERIAL_PLASTIC;
    read_eta(p, "polypropylene", material);
    read_albedo(p, textures, "diffuse_reflectance", material);
    read_specular(p, textures, material);
    material.nonlinear = p.boolean("nonlinear", false);
    return material;
}

SceneMaterial read_rough_plastic(Properties& p, TextureReader& textures) {
    SceneMaterial material = read_plastic(p, textures);
    read_roughness(p, textures, material);
    return material;
}

SceneMaterial read_phong(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    material.model = MATERIAL_PHONG;
    read_albedo(p, textures, "diffuse_reflectance", material);
    read_specular(p, textures, material, 0.2F);
    const NumberSlot exponent = textures.number(p, "exponent", 30);
    material.exponent = exponent.texture == no_texture ? exponent.value : 30.0F;
    if (exponent.texture != no_texture) p.approximate("", "a texture as exponent is not supported: 30 is used");
    conserve_energy(p, textures, material);
    return material;
}

/// Ward's lobe around the half vector, exp(-tan^2 / alpha^2), is about cos^(2 / alpha^2); around the mirror direction, at twice the angle, a
/// quarter of that exponent.
SceneMaterial read_ward(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    material.model = MATERIAL_PHONG;
    read_albedo(p, textures, "diffuse_reflectance", material);
    read_specular(p, textures, material, 0.2F);
    const NumberSlot both = textures.number(p, "alpha", 0.1);
    const NumberSlot u = p.has_slot("alpha_u") ? textures.number(p, "alpha_u", 0.1) : both;
    const NumberSlot v = p.has_slot("alpha_v") ? textures.number(p, "alpha_v", 0.1) : both;
    material.exponent = 0.5F / std::max(u.value * v.value, 1e-6F);
    p.approximate("", "is not supported: read as phong of about the same width");
    p.ignore({"variant"});
    conserve_energy(p, textures, material);
    return material;
}

}  // namespace pencil
