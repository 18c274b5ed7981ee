// MTL says how surfaces look by lamps alone, and programs write it by habits. Read here: Kd is diffuse; Ks and Ns are a boundary of the
// strength that Blender gives Ks, 0.08 of it head on; models that mirror the surroundings (illum 3, 5, 8) take Ks as it is.
#include "scene/models/mtl_scattering.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "scene/scene_file.h"
#include "scene/text.h"
#include "scene/textures/add_texture.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr TextureUse luminance_use{1.0, TextureUse::Channel::luminance};

glm::vec3 unit(const glm::dvec3& colour) { return glm::vec3(glm::clamp(colour, glm::dvec3(0.0), glm::dvec3(1.0))); }

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

class MtlScattering {
public:
    MtlScattering(const MtlMaterial& material, const MtlContext& context, Scene& scene)
        : material_(material), context_(context), scene_(scene) {}

    std::uint32_t add() {
        SceneMaterial result = is_glass() ? glass() : opaque();
        result.id = material_.name;
        relief(result);
        if (!is_glass()) cover(result);
        return static_cast<std::uint32_t>(append(result));
    }

    /// no_texture if there is none, or none that can be read.
    int texture(const MtlMap& map, const TextureUse& use) {
        if (map.file.empty()) return no_texture;
        TextureSampling sampling;
        // v is turned before and after, since it grows upwards where the options speak of it.
        sampling.to_uv = glm::dmat3(map.scale.x, 0, 0, 0, map.scale.y, 0, map.offset.x, 1 - map.scale.y - map.offset.y, 1);
        if (map.clamp) sampling.wrap_u = sampling.wrap_v = Texture::Wrap::clamp;
        try {
            const std::filesystem::path file = context_.search.find(map.file, context_.folder, context_.where);
            return add_texture_file(scene_, file, use, context_.where, sampling);
        } catch (const SceneError& error) {
            leave_out(error, "; material " + in_quotes(material_.name) + " goes without", context_.where, context_.problems);
            return no_texture;
        }
    }

private:
    std::int64_t append(const SceneMaterial& material) {
        scene_.materials.push_back(material);
        return static_cast<std::int64_t>(scene_.materials.size()) - 1;
    }

    double opacity() const { return std::clamp(material_.opacity.value_or(1.0), 0.0, 1.0); }

    /// Models 6 and 7 refract; 4 and 9 do so where something is seen through them.
    bool is_glass() const {
        const int model = material_.model.value_or(0);
        const bool is_clear = opacity() < 1 || (material_.filter && largest(*material_.filter) < 1);
        return model == 6 || model == 7 || ((model == 4 || model == 9) && is_clear);
    }

    SceneMaterial glass() {
        SceneMaterial result;
        result.model = MATERIAL_DIELECTRIC;
        result.transmitted = unit(material_.filter.value_or(glm::dvec3(1.0)));
        const double index = material_.index.value_or(1.5);
        result.eta = glm::vec3(static_cast<float>(index > 1.001 && index < 100 ? index : 1.5));
        return result;
    }

    SceneMaterial opaque() {
        SceneMaterial result;
        result.two_sided = true;
        result.albedo_texture = texture(material_.diffuse_map, colour_use);
        const bool has_texture = result.albedo_texture != no_texture;
        glm::dvec3 diffuse = material_.diffuse.value_or(glm::dvec3(has_texture ? 1.0 : 0.5));
        if (has_texture && diffuse == glm::dvec3(0.0)) diffuse = glm::dvec3(1.0);  // written where the picture is meant to stand for it
        result.albedo = unit(diffuse);
        const glm::dvec3 specular = material_.specular.value_or(glm::dvec3(0.0));
        const int model = material_.model.value_or(2);
        if (material_.roughness || material_.metallic)
            principled(material_.roughness.value_or(0.5), material_.metallic.value_or(0.0), 0.5, result);
        else if ((model == 3 || model == 5 || model == 8) && largest(specular) > 0)
            mirroring(specular, result);
        else if (model >= 2 && largest(specular) > 0)
            principled(std::sqrt(std::sqrt(2 / (exponent() + 2))), 0, largest(specular), result);
        return result;
    }

    double exponent() const { return std::clamp(material_.exponent.value_or(10.0), 0.0, 1e6); }

    static void principled(double roughness, double metallic, double specular, SceneMaterial& result) {
        result.model = MATERIAL_PRINCIPLED;
        result.alpha = glm::vec2(static_cast<float>(std::clamp(roughness, 0.0, 1.0)));
        result.principled.metallic = static_cast<float>(std::clamp(metallic, 0.0, 1.0));
        const double root = std::sqrt(0.08 * std::clamp(specular, 0.0, 1.0));
        result.eta = glm::vec3(static_cast<float>(std::max((1 + root) / (1 - root), 1.001)));
    }

    /// What both parts reflect together is no more than all.
    void mirroring(const glm::dvec3& specular, SceneMaterial& result) const {
        result.model = MATERIAL_PHONG;
        result.specular = unit(glm::min(specular, 1.0 - glm::dvec3(result.albedo)));
        result.exponent = static_cast<float>(std::max(exponent(), 1.0));
    }

    void relief(SceneMaterial& result) {
        result.normal_texture = texture(material_.normal_map, raw_use);
        result.y_against_v = true;
        if (result.normal_texture != no_texture || material_.bump_map.file.empty()) return;
        result.normal_texture = texture(material_.bump_map, luminance_use);
        result.bump = result.normal_texture != no_texture;
        result.bump_scale = static_cast<float>(std::clamp(material_.bump_map.bump_multiplier, -1e6, 1e6));
    }

    void cover(SceneMaterial& result) {
        bool by_opacity = false;
        const int map = opacity_texture(by_opacity);
        if (map == no_texture && opacity() >= 1) return;
        SceneMaterial pass, mask;
        pass.id = "pass";
        pass.model = MATERIAL_PASS;
        mask.id = result.id;
        mask.model = MATERIAL_BLEND;
        pass.two_sided = mask.two_sided = true;
        mask.blended[0] = append(pass);
        mask.blended[1] = append(result);
        mask.weight = static_cast<float>(opacity());
        mask.weight_texture = map;
        mask.weight_is_opacity = by_opacity;
        result = mask;
    }

    /// The picture's opacity where it has one, else its brightness.
    int opacity_texture(bool& by_opacity) {
        const int all = texture(material_.opacity_map, colour_use);
        if (all == no_texture) return no_texture;
        const std::vector<glm::u16vec4>& texels = scene_.textures[static_cast<std::size_t>(all)].texels;
        constexpr std::uint16_t one = 0x3c00;
        by_opacity = std::any_of(texels.begin(), texels.end(), [](const glm::u16vec4& texel) { return texel.w != one; });
        return by_opacity ? all : texture(material_.opacity_map, luminance_use);
    }

    const MtlMaterial& material_;
    const MtlContext& context_;
    Scene& scene_;
};

}  // namespace

std::uint32_t add_mtl_material(const MtlMaterial& material, const MtlContext& context, Scene& scene) {
    for (const std::string& statement : material.left_out)
        context.problems.approximate(context.where, "material " + in_quotes(material.name) + ": " + statement + " is left out");
    return MtlScattering(material, context, scene).add();
}

void set_mtl_emission(const MtlMaterial& material, const MtlContext& context, Scene& scene, Shape& shape) {
    const bool has_map = !material.emission_map.file.empty();
    const glm::dvec3 radiance = material.emission.value_or(glm::dvec3(has_map ? 1.0 : 0.0));
    if (!(largest(radiance) > 0)) return;
    shape.radiance_texture = MtlScattering(material, context, scene).texture(material.emission_map, colour_use);
    if (has_map && shape.radiance_texture == no_texture && !material.emission) return;
    shape.emits = true;
    shape.radiance = glm::vec3(glm::min(radiance, glm::dvec3(1e30)));
}

void leave_out(const SceneError& error, const std::string& consequence, const std::string& where, Problems& problems) {
    problems.approximate(where, without_place(error, where) + consequence);
}

SceneMaterial unnamed_material() {
    SceneMaterial material;
    material.id = "default";
    material.two_sided = true;
    return material;
}

}  // namespace pencil
