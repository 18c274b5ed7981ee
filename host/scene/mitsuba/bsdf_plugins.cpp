// The table of models, and the parameters that they share.
#include "scene/mitsuba/bsdf_plugins.h"

#include <map>

#include "scene/mitsuba/refraction_index.h"
#include "scene/text.h"

namespace pencil {
namespace {

const std::map<std::string, BsdfPlugin> plugins = {
    {"diffuse", read_diffuse},
    {"roughdiffuse", read_rough_diffuse},
    {"null", read_null},
    {"conductor", read_conductor},
    {"roughconductor", read_rough_conductor},
    {"dielectric", read_dielectric},
    {"thindielectric", read_thin_dielectric},
    {"roughdielectric", read_rough_dielectric},
    {"plastic", read_plastic},
    {"roughplastic", read_rough_plastic},
    {"pplastic", read_rough_plastic},
    {"phong", read_phong},
    {"ward", read_ward},
    {"principled", read_principled},
    {"principledthin", read_principled_thin},
};

}  // namespace

BsdfPlugin find_bsdf_plugin(const std::string& type) {
    const auto place = plugins.find(type);
    return place == plugins.end() ? nullptr : place->second;
}

double read_index(Properties& p, const std::string& name, const std::string& absent) {
    const std::string text = p.text(name, absent);
    const std::optional<double> number = parse_number(text);
    if (number) {
        if (!(*number > 0.0)) p.fail(name, name + " must be positive");
        return *number;
    }
    const std::optional<double> named = refraction_index(text);
    if (named) return *named;
    const std::string close = closest_name(text, refraction_names());
    p.fail(name, name + " " + in_quotes(text) + " is neither a number nor a known name" +
                     (close.empty() ? "" : "; did you mean " + in_quotes(close) + "?"));
}

void read_albedo(Properties& p, TextureReader& textures, const std::string& name, SceneMaterial& material) {
    const ColourSlot slot = textures.colour(p, name, glm::vec3(0.5F), ColourUse::reflectance);
    material.albedo = slot.value;
    material.albedo_texture = slot.texture;
}

void read_specular(Properties& p, TextureReader& textures, SceneMaterial& material, float absent) {
    const ColourSlot slot = textures.colour(p, "specular_reflectance", glm::vec3(absent), ColourUse::reflectance);
    material.specular = slot.value;
    material.specular_texture = slot.texture;
}

void read_roughness(Properties& p, TextureReader& textures, SceneMaterial& material) {
    const std::string distribution = p.text("distribution", "beckmann");
    material.beckmann = distribution != "ggx";
    if (distribution != "ggx" && distribution != "beckmann")
        p.approximate("distribution", "distribution " + in_quotes(distribution) + " is not supported: read as \"beckmann\"");
    const NumberSlot both = textures.number(p, "alpha", 0.1);
    const NumberSlot u = p.has_slot("alpha_u") ? textures.number(p, "alpha_u", 0.1) : both;
    const NumberSlot v = p.has_slot("alpha_v") ? textures.number(p, "alpha_v", 0.1) : both;
    material.alpha = {u.value, v.value};
    material.alpha_texture = u.texture;
    if (u.texture != v.texture) p.approximate("alpha_v", "alpha_u and alpha_v cannot have different textures: alpha_u's is used for both");
    p.ignore({"sample_visible", "alpha"});
}

void read_eta(Properties& p, const std::string& inside, SceneMaterial& material) {
    const double outside = read_index(p, "ext_ior", "air");
    material.eta = glm::vec3(static_cast<float>(read_index(p, "int_ior", inside) / outside));
}

}  // namespace pencil
