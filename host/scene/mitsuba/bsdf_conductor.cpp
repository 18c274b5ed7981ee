#include "scene/mitsuba/bsdf_plugins.h"
#include "scene/mitsuba/metals.h"
#include "scene/text.h"

namespace pencil {
namespace {

void reflect_everything(SceneMaterial& material) {
    material.perfect_mirror = true;
    material.eta = glm::vec3(0.0F);
    material.k = glm::vec3(1.0F);
}

void read_named(Properties& p, const std::string& name, SceneMaterial& material) {
    if (name == "none") return reflect_everything(material);
    if (const std::optional<ComplexIndex> index = metal(name)) {
        material.eta = index->eta;
        material.k = index->k;
        return;
    }
    const std::string close = closest_name(name, metal_names());
    p.approximate("material", "material " + in_quotes(name) + " is not known" +
                                  (close.empty() ? "" : " (did you mean " + in_quotes(close) + "?)") + ": read as \"none\"");
    reflect_everything(material);
}

/// Mitsuba 0.x stands copper in where nothing is said, later versions what reflects everything.
void read_material(Properties& p, SceneMaterial& material) {
    const std::string name = p.text("material", p.source().version(p.node()) < 2 ? "Cu" : "none");
    if (p.has_slot("eta") || p.has_slot("k")) {
        material.eta = p.colour("eta", glm::vec3(0.0F), ColourUse::coefficient);
        material.k = p.colour("k", glm::vec3(1.0F), ColourUse::coefficient);
    } else {
        read_named(p, name, material);
    }
    if (!p.has("ext_eta")) return;
    const auto outside = static_cast<float>(read_index(p, "ext_eta", "air"));
    material.eta /= outside;
    material.k /= outside;
}

}  // namespace

SceneMaterial read_conductor(Properties& p, TextureReader& textures) {
    SceneMaterial material;
    material.model = MATERIAL_CONDUCTOR;
    read_material(p, material);
    read_specular(p, textures, material);
    return material;
}

SceneMaterial read_rough_conductor(Properties& p, TextureReader& textures) {
    SceneMaterial material = read_conductor(p, textures);
    read_roughness(p, textures, material);
    return material;
}

}  // namespace pencil
