#include <algorithm>

#include "scene/mitsuba/bsdf_plugins.h"

namespace pencil {

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
    return material;
}

}  // namespace pencil
