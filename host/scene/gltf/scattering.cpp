// Both models are Disney's at heart: roughness is the square root of the microfacets' alpha, and the base colour is shared by the diffuse part
// and the metal.
#include "scene/gltf/scattering.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/gltf/gltf_values.h"
#include "scene/gltf/specular_glossiness.h"

namespace pencil {
namespace {

constexpr double default_index = 1.5;
constexpr TextureUse green_use{1.0, TextureUse::Channel::green}, blue_use{1.0, TextureUse::Channel::blue},
    red_use{1.0, TextureUse::Channel::red};

float unit(double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); }

}  // namespace

const tinygltf::Value* Scattering::extension(const char* name) const { return find_extension(material_.extensions, name); }

int Scattering::texture(const tinygltf::TextureInfo& info, const TextureUse& use, const char* what) {
    return textures_.add(info, use, uv_set_, "the " + std::string(what) + " texture of " + label_);
}

void Scattering::leave_out_textures(const char* name, std::initializer_list<const char*> textures) {
    for (const char* texture : textures)
        if (texture_of(extension(name), texture).index >= 0) file_.approximate(label_ + ": " + texture + " is left out");
}

void Scattering::base_colour(SceneMaterial& result) {
    const tinygltf::PbrMetallicRoughness& pbr = material_.pbrMetallicRoughness;
    for (int i = 0; i < 3; ++i) result.albedo[i] = unit(pbr.baseColorFactor[static_cast<std::size_t>(i)]);
    result.albedo_texture = texture(pbr.baseColorTexture, colour_use, "base colour");
}

SceneMaterial Scattering::reflecting() {
    SceneMaterial result;
    result.two_sided = true;
    base_colour(result);
    relief(result);
    if (extension("KHR_materials_unlit")) {
        file_.approximate(label_ + " is unlit, which no surface is; it is read as a diffuse one");
        return result;
    }
    result.model = MATERIAL_PRINCIPLED;
    result.eta = glm::vec3(static_cast<float>(effective_index()));
    if (const tinygltf::Value* glossy = extension("KHR_materials_pbrSpecularGlossiness")) {
        specular_glossiness(*glossy, result);
        return result;
    }
    const tinygltf::PbrMetallicRoughness& pbr = material_.pbrMetallicRoughness;
    result.alpha = glm::vec2(unit(pbr.roughnessFactor));
    result.principled.metallic = unit(pbr.metallicFactor);
    if (result.alpha.x > 0) result.alpha_texture = texture(pbr.metallicRoughnessTexture, green_use, "roughness");
    if (result.principled.metallic > 0) result.principled.metallic_texture = texture(pbr.metallicRoughnessTexture, blue_use, "metallic");
    coats(result);
    return result;
}

/// The base colour so far is the diffuse one.
void Scattering::specular_glossiness(const tinygltf::Value& glossy, SceneMaterial& result) {
    const glm::vec3 specular = glm::clamp(colour_of(&glossy, "specularFactor", glm::vec3(1.0F)), glm::vec3(0.0F), glm::vec3(1.0F));
    const float gloss = unit(number_of(&glossy, "glossinessFactor", 1.0));
    const int picture = texture(texture_of(&glossy, "specularGlossinessTexture"), colour_use, "specular");
    const int diffuse_picture = result.albedo_texture;
    const glm::vec3 diffuse = result.albedo;
    if (picture == no_texture && diffuse_picture == no_texture) {
        const BaseAndMetallic material = metallic_of_specular(diffuse, specular);
        result.albedo = material.base;
        result.principled.metallic = material.metallic;
    } else {
        const std::string change = label_ + " as metallic: ";
        const auto converted = [=](const glm::vec4& d, const glm::vec4& s) {
            return metallic_of_specular(glm::max(diffuse * glm::vec3(d), glm::vec3(0.0F)),
                                        glm::max(specular * glm::vec3(s), glm::vec3(0.0F)));
        };
        result.albedo = glm::vec3(1.0F);
        result.albedo_texture =
            textures_.add_combined(diffuse_picture, picture, change + "base", [=](const glm::vec4& d, const glm::vec4& s) {
                return glm::vec4(converted(d, s).base, diffuse_picture == no_texture ? 1.0F : d.w);
            });
        result.principled.metallic = 1;
        result.principled.metallic_texture = textures_.add_combined(
            diffuse_picture, picture, change + "metallic",
            [=](const glm::vec4& d, const glm::vec4& s) { return glm::vec4(glm::vec3(converted(d, s).metallic), 1.0F); });
    }
    result.alpha = glm::vec2(picture == no_texture ? 1 - gloss : 1.0F);
    if (picture != no_texture)
        result.alpha_texture = textures_.add_changed(picture, "roughness of gloss times " + std::to_string(gloss),
                                                     [=](const glm::vec4& s) { return glm::vec4(glm::vec3(1 - gloss * s.w), 1.0F); });
}

double Scattering::index_of_refraction() const {
    const double index = number_of(extension("KHR_materials_ior"), "ior", default_index);
    return index >= 1 && index < 100 ? index : default_index;
}

/// The index whose reflection at normal incidence is that of the material; one is the least with which there is a boundary.
double Scattering::effective_index() const {
    const tinygltf::Value* specular = extension("KHR_materials_specular");
    const double index = index_of_refraction(), amplitude = (index - 1) / (index + 1);
    const glm::vec3 colour = glm::max(colour_of(specular, "specularColorFactor", glm::vec3(1.0F)), glm::vec3(0.0F));
    const double strongest = std::max({colour.x, colour.y, colour.z});
    const double factor = std::clamp(number_of(specular, "specularFactor", 1.0), 0.0, 1.0);
    const double root = std::sqrt(std::min(amplitude * amplitude * strongest, 0.9) * factor);
    return std::max((1 + root) / (1 - root), 1.001);
}

void Scattering::coats(SceneMaterial& result) {
    const tinygltf::Value *specular = extension("KHR_materials_specular"), *coat = extension("KHR_materials_clearcoat"),
                          *sheen = extension("KHR_materials_sheen");
    const glm::vec3 tint = colour_of(specular, "specularColorFactor", glm::vec3(1.0F));
    if (tint != glm::vec3(tint.x)) file_.approximate(label_ + ": the colour of its highlights is left out, their strength is kept");
    leave_out_textures("KHR_materials_specular", {"specularTexture", "specularColorTexture"});
    result.principled.clearcoat = unit(number_of(coat, "clearcoatFactor", 0));
    result.principled.clearcoat_gloss = 1 - unit(number_of(coat, "clearcoatRoughnessFactor", 0));
    leave_out_textures("KHR_materials_clearcoat", {"clearcoatTexture", "clearcoatRoughnessTexture", "clearcoatNormalTexture"});
    const glm::vec3 fuzz = glm::clamp(colour_of(sheen, "sheenColorFactor", glm::vec3(0.0F)), glm::vec3(0.0F), glm::vec3(1.0F));
    result.principled.sheen = std::max({fuzz.x, fuzz.y, fuzz.z});
    result.principled.sheen_tint = fuzz == glm::vec3(fuzz.x) ? 0.0F : 1.0F;
    if (result.principled.sheen > 0) file_.approximate(label_ + ": its sheen is approximated by that of the principled model");
    leave_out_textures("KHR_materials_sheen", {"sheenColorTexture", "sheenRoughnessTexture"});
}

/// The scale of a normal map goes into a copy of it.
void Scattering::relief(SceneMaterial& result) {
    const tinygltf::NormalTextureInfo& normal = material_.normalTexture;
    tinygltf::TextureInfo info;
    info.index = normal.index;
    info.texCoord = normal.texCoord;
    info.extensions = normal.extensions;
    result.normal_texture = texture(info, raw_use, "normal");
    result.y_against_v = true;
    const double given = normal.scale;
    if (result.normal_texture == no_texture || given == 1 || !std::isfinite(given)) return;
    const auto scale = static_cast<float>(given);
    result.normal_texture =
        textures_.add_changed(result.normal_texture, "normals scaled by " + std::to_string(given), [scale](glm::vec4 texel) {
            const glm::vec3 n = (2.0F * glm::vec3(texel) - 1.0F) * glm::vec3(scale, scale, 1.0F);
            const float length = glm::length(n);
            return length > 0 ? glm::vec4(0.5F + 0.5F * n / length, texel.w) : texel;
        });
}

double Scattering::transmission() const {
    const double share = std::clamp(number_of(extension("KHR_materials_transmission"), "transmissionFactor", 0), 0.0, 1.0);
    return share * (1 - std::clamp(material_.pbrMetallicRoughness.metallicFactor, 0.0, 1.0));
}

int Scattering::transmission_texture() {
    return texture(texture_of(extension("KHR_materials_transmission"), "transmissionTexture"), red_use, "transmission");
}

/// Without a thickness the surface is a thin wall, which turns no light; roughness cannot be given to such a one.
SceneMaterial Scattering::transmitting() {
    SceneMaterial result;
    result.model = MATERIAL_DIELECTRIC;
    base_colour(result);
    result.transmitted = result.albedo;
    result.transmitted_texture = result.albedo_texture;
    result.albedo = glm::vec3(0.5F);
    result.albedo_texture = no_texture;
    result.eta = glm::vec3(static_cast<float>(std::max(index_of_refraction(), 1.001)));
    const tinygltf::Value* volume = extension("KHR_materials_volume");
    result.thin = !(number_of(volume, "thicknessFactor", 0) > 0);
    if (volume && find_extension(material_.extensions, "KHR_materials_volume")->Has("attenuationDistance"))
        file_.approximate(label_ + ": absorption inside of it is left out");
    const double roughness = std::clamp(material_.pbrMetallicRoughness.roughnessFactor, 0.0, 1.0);
    constexpr double smooth = 0.03;
    if (roughness < smooth) return result;
    if (result.thin)
        file_.approximate(label_ + " is a rough thin wall; it is read as a smooth one");
    else
        result.alpha = glm::vec2(static_cast<float>(roughness * roughness));
    if (!result.thin && material_.pbrMetallicRoughness.metallicRoughnessTexture.index >= 0)
        file_.approximate(label_ + ": the roughness texture is left out, since it transmits light");
    return result;
}

}  // namespace pencil
