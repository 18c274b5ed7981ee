#include "scene/mitsuba/bsdf_plugins.h"

namespace pencil {

SceneMaterial read_dielectric(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    material.model = MATERIAL_DIELECTRIC;
    read_eta(p, "bk7", material);
    read_specular(p, textures, material);
    const ColourSlot slot = textures.colour(p, "specular_transmittance", glm::vec3(1.0F), ColourUse::reflectance);
    material.transmitted = slot.value;
    material.transmitted_texture = slot.texture;
    return material;
}

SceneMaterial read_thin_dielectric(Properties& p, TextureReader& textures) {
    SceneMaterial material = read_dielectric(p, textures);
    material.thin = true;
    return material;
}

SceneMaterial read_rough_dielectric(Properties& p, TextureReader& textures) {
    SceneMaterial material = read_dielectric(p, textures);
    read_roughness(p, textures, material);
    return material;
}

}  // namespace pencil
