// What lies behind another index is appended before: blends name materials of lower index.
#include "scene/gltf/read_material.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>
#include <limits>

#include "scene/gltf/gltf_values.h"

namespace pencil {

const tinygltf::Material& MaterialReader::at(int material) const {
    return material < 0 ? default_ : file_.at(file_.model().materials, material, "material", "a primitive");
}

std::string MaterialReader::label(int material) const {
    return material < 0 ? "the default material" : named("material", static_cast<std::size_t>(material), at(material).name);
}

std::int64_t MaterialReader::add(const SceneMaterial& material) {
    scene_.materials.push_back(material);
    return static_cast<std::int64_t>(scene_.materials.size()) - 1;
}

/// Of the first texture that there is.
int MaterialReader::uv_set(int index) const {
    const tinygltf::Material& material = at(index);
    const tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
    for (const tinygltf::TextureInfo* info : {&pbr.baseColorTexture, &pbr.metallicRoughnessTexture, &material.emissiveTexture})
        if (info->index >= 0) return uv_set_of(*info);
    return material.normalTexture.index >= 0 ? material.normalTexture.texCoord : 0;
}

std::uint32_t MaterialReader::read(int index, bool vertex_colours) {
    const auto known = read_.find({index, vertex_colours});
    if (known != read_.end()) return known->second;
    const tinygltf::Material& material = at(index);
    Scattering scattering(file_, textures_, material, uv_set(index), label(index));
    SceneMaterial result = scattering.reflecting();
    result.id = index < 0 ? "default" : material.name;
    if (vertex_colours && result.albedo_texture != no_texture)
        file_.approximate(label(index) + " has a texture and colours of vertices; only the texture is used");
    if (vertex_colours && result.albedo_texture == no_texture) result.albedo_texture = textures_.vertex_colours();
    const int opacity_texture = material.pbrMetallicRoughness.baseColorTexture.index >= 0 ? result.albedo_texture : no_texture;
    if (scattering.transmits()) result = partly_transmitting(result, scattering);
    result = partly_covering(std::move(result), material, opacity_texture);
    if (material.occlusionTexture.index >= 0) file_.warn("occlusion textures are left out: light is computed");
    const auto number = static_cast<std::uint32_t>(add(result));
    read_[{index, vertex_colours}] = number;
    return number;
}

/// All of the light that no metal reflects, or a share of it.
SceneMaterial MaterialReader::partly_transmitting(const SceneMaterial& reflecting, Scattering& scattering) {
    SceneMaterial transmitting = scattering.transmitting();
    transmitting.id = reflecting.id;
    transmitting.normal_texture = reflecting.normal_texture;
    transmitting.y_against_v = reflecting.y_against_v;
    const int texture = scattering.transmission_texture();
    if (texture == no_texture && scattering.transmission() >= 1) return transmitting;
    return blend(reflecting, transmitting, static_cast<float>(scattering.transmission()), texture);
}

SceneMaterial MaterialReader::blend(const SceneMaterial& first, const SceneMaterial& second, float weight, int texture) {
    SceneMaterial result;
    result.id = first.id;
    result.model = MATERIAL_BLEND;
    result.two_sided = true;
    result.blended[0] = add(first);
    result.blended[1] = add(second);
    result.weight = weight;
    result.weight_texture = texture;
    return result;
}

/// Opacity: nothing, or a blend with what lets light pass. A cutoff makes it 0 or 1 in a copy of the texture.
SceneMaterial MaterialReader::partly_covering(SceneMaterial result, const tinygltf::Material& material, int texture) {
    const bool is_mask = material.alphaMode == "MASK";
    if (!is_mask && material.alphaMode != "BLEND") return result;
    auto weight = static_cast<float>(std::clamp(material.pbrMetallicRoughness.baseColorFactor[3], 0.0, 1.0));
    const auto cutoff = static_cast<float>(std::clamp(material.alphaCutoff, 0.0, 1e6));
    if (texture != no_texture && is_opaque(texture)) texture = no_texture;
    if (is_mask && texture == no_texture) weight = weight >= cutoff ? 1.0F : 0.0F;
    if (texture == no_texture && weight >= 1) return result;
    if (is_mask && texture != no_texture) {
        const std::string change = "opacity times " + std::to_string(weight) + " cut at " + std::to_string(cutoff);
        texture = textures_.add_changed(
            texture, change, [=](glm::vec4 texel) { return glm::vec4(glm::vec3(texel), texel.w * weight >= cutoff ? 1.0F : 0.0F); });
        weight = 1;
    }
    if (pass_ < 0) {
        SceneMaterial pass;
        pass.id = "pass";
        pass.model = MATERIAL_PASS;
        pass.two_sided = true;
        pass_ = add(pass);
    }
    SceneMaterial mask;
    mask.id = result.id;
    mask.model = MATERIAL_BLEND;
    mask.two_sided = true;
    mask.blended[0] = pass_;
    mask.blended[1] = add(result);
    mask.weight = weight;
    mask.weight_texture = texture;
    mask.weight_is_opacity = texture != no_texture;
    return mask;
}

bool MaterialReader::is_opaque(int texture) const {
    const std::vector<glm::u16vec4>& texels = scene_.textures[static_cast<std::size_t>(texture)].texels;
    const std::uint16_t one = glm::packHalf1x16(1.0F);
    return std::all_of(texels.begin(), texels.end(), [one](const glm::u16vec4& texel) { return texel.w == one; });
}

/// One unit of emissive strength is one unit of radiance, as Blender has it; the specification's nits would be 683 times less.
void MaterialReader::read_emission(int index, Shape& shape) {
    const tinygltf::Material& material = at(index);
    const double strength = number_of(find_extension(material.extensions, "KHR_materials_emissive_strength"), "emissiveStrength", 1.0);
    for (std::size_t i = 0; i < material.emissiveFactor.size() && i < 3; ++i) {
        const double value = material.emissiveFactor[i] * strength;
        if (!(value >= 0 && value <= std::numeric_limits<float>::max()))
            file_.fail(label(index) + ": what it emits must be numbers from 0 to 3.4e38");
        shape.radiance[static_cast<int>(i)] = static_cast<float>(value);
    }
    if (shape.radiance == glm::vec3(0.0F)) return;
    shape.radiance_texture = textures_.add(material.emissiveTexture, colour_use, uv_set(index), "the emissive texture of " + label(index));
    if (material.emissiveTexture.index >= 0 && shape.radiance_texture == no_texture) {  // which says what parts emit
        file_.approximate(label(index) + " emits nothing, for want of its emissive texture");
        shape.radiance = glm::vec3(0.0F);
        return;
    }
    shape.emits = true;
    if (material.doubleSided) file_.approximate("surfaces that emit do so from their fronts alone, also where both sides are shown");
}

}  // namespace pencil
