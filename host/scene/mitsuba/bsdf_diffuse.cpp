#include <cmath>

#include "scene/mitsuba/bsdf_plugins.h"

namespace pencil {

SceneMaterial read_diffuse(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    read_albedo(p, textures, p.has_slot("diffuse_reflectance") ? "diffuse_reflectance" : "reflectance",
                material);  // the former: an alias in 0.x
    return material;
}

SceneMaterial read_rough_diffuse(Properties& p, TextureReader& textures) {
    SceneMaterial material = read_diffuse(p, textures);
    material.model = MATERIAL_ROUGH_DIFFUSE;
    const NumberSlot alpha = textures.number(p, "alpha", 0.2);
    // Mitsuba's alpha is Beckmann's; Oren and Nayar's standard deviation is smaller by this factor.
    material.alpha = glm::vec2(alpha.value / std::sqrt(2.0F));
    material.alpha_texture = alpha.texture;
    p.ignore({"use_fast_approx"});
    return material;
}

SceneMaterial read_null(Properties&, TextureReader&) {
    SceneMaterial material;
    material.model = MATERIAL_PASS;
    return material;
}

SceneMaterial read_unknown_bsdf(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    for (const char* name : {"reflectance", "diffuse_reflectance", "base_color", "color", "transmittance", "albedo", "diffuse"}) {
        if (!p.has_slot(name)) continue;
        read_albedo(p, textures, name, material);
        break;
    }
    material.two_sided = true;  // it may stand for something that light goes through
    p.approximate("", "is not supported: read as diffuse");
    return material;
}

}  // namespace pencil
