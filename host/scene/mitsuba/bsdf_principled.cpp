// Disney's principled BSDF (Mitsuba 2, 3).
#include <algorithm>
#include <cmath>

#include "scene/mitsuba/bsdf_plugins.h"

namespace pencil {
namespace {

/// Parameters that are one number for the whole surface here; Mitsuba takes textures, too.
float plain(Properties& p, TextureReader& textures, const std::string& name) {
    const NumberSlot slot = textures.number(p, name, 0);
    if (slot.texture != no_texture) p.approximate("", "a texture as " + name + " is not supported: its factor is used");
    return slot.value;
}

void read_common(Properties& p, TextureReader& textures, SceneMaterial& material) {
    material.model = MATERIAL_PRINCIPLED;
    read_albedo(p, textures, "base_color", material);
    const NumberSlot roughness = textures.number(p, "roughness", 0.5);
    material.alpha = glm::vec2(roughness.value);
    material.alpha_texture = roughness.texture;
    PrincipledParameters& d = material.principled;
    d.anisotropic = plain(p, textures, "anisotropic");
    d.spec_trans = plain(p, textures, "spec_trans");
    d.spec_tint = plain(p, textures, "spec_tint");
    d.sheen = plain(p, textures, "sheen");
    d.sheen_tint = plain(p, textures, "sheen_tint");
    d.flatness = plain(p, textures, "flatness");
    p.ignore({"diffuse_reflectance_sampling_rate", "main_specular_sampling_rate", "clearcoat_sampling_rate", "spec_refl_sampling_rate",
              "spec_trans_sampling_rate", "diff_trans_sampling_rate", "diff_refl_sampling_rate"});
}

}  // namespace

SceneMaterial read_principled(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    read_common(p, textures, material);
    PrincipledParameters& d = material.principled;
    const NumberSlot metallic = textures.number(p, "metallic", 0);
    d.metallic = metallic.value;
    d.metallic_texture = metallic.texture;
    d.clearcoat = plain(p, textures, "clearcoat");
    d.clearcoat_gloss = plain(p, textures, "clearcoat_gloss");
    if (p.has("eta")) {
        material.eta = glm::vec3(static_cast<float>(p.number("eta", 1.5)));
    } else {
        // The reflectance at normal incidence is 0.08 times "specular".
        const double specular = std::max(p.number("specular", 0.5), 1e-3);
        material.eta = glm::vec3(static_cast<float>(2.0 / (1.0 - std::sqrt(0.08 * std::min(specular, 12.0))) - 1.0));
    }
    return material;
}

/// Light that goes through a thin sheet is left out.
SceneMaterial read_principled_thin(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    read_common(p, textures, material);
    material.principled.spec_trans = 0;
    material.two_sided = true;
    material.eta = glm::vec3(static_cast<float>(p.number("eta", 1.5)));
    p.ignore({"diff_trans"});
    p.approximate("", "is not supported: read as principled, opaque and two-sided");
    return material;
}

}  // namespace pencil
