#include "reference/surface_table.h"

#include <algorithm>

#include "scene/texture_lookup.h"

namespace pencil {
namespace {

bool plain_material(const SceneMaterial& m) {
    return m.model == MATERIAL_DIFFUSE && m.albedo_texture == no_texture && m.normal_texture == no_texture && m.back < 0;
}

bool passes(const SurfaceSide& side) {
    return side.material.model == MATERIAL_PASS || (side.material.model == MATERIAL_DIELECTRIC && side.material.thin);
}

}  // namespace

SurfaceTable::SurfaceTable(const Scene& scene) : textures_(scene.textures), sides_(2 * scene.materials.size()) {
    for (std::size_t i = 0; i < scene.materials.size(); ++i) sides_[2 * i] = front_of(scene.materials[i]);
    for (std::size_t i = 0; i < scene.materials.size(); ++i) sides_[2 * i + 1] = back_of(scene.materials[i], sides_[2 * i]);
    for (const SurfaceSide& side : sides_) may_pass_ = may_pass_ || side.may_pass;
    plain_ = std::all_of(scene.materials.begin(), scene.materials.end(), plain_material) &&
             std::all_of(scene.shapes.begin(), scene.shapes.end(), [](const Shape& s) { return s.radiance_texture == no_texture; });
}

SurfaceSide SurfaceTable::front_of(const SceneMaterial& m) {
    SurfaceSide side;
    side.source = &m;
    side.material = {m.model,          false,      false,       m.albedo, m.specular, m.transmitted, m.eta, m.k, m.alpha,
                     m.perfect_mirror, m.beckmann, m.nonlinear, m.thin,   m.exponent, m.principled};
    side.textured = m.albedo_texture != no_texture || m.specular_texture != no_texture || m.transmitted_texture != no_texture ||
                    m.alpha_texture != no_texture || m.principled.metallic_texture != no_texture;
    side.relief = m.normal_texture != no_texture;
    side.tangents = side.relief || m.alpha.x != m.alpha.y || m.principled.anisotropic > 0.0F;
    if (m.model == MATERIAL_PLASTIC) {
        tables_.push_back(std::make_unique<PlasticTable>(m.eta.x, m.alpha.x, m.beckmann, m.alpha_texture != no_texture));
        side.material.table = tables_.back().get();
    }
    if (side.blend())
        for (int k = 0; k < 2; ++k) side.blended[k] = number(static_cast<std::uint32_t>(m.blended[k]), true);
    side.may_pass = passes(side) || (side.blend() && (sides_[side.blended[0]].may_pass || sides_[side.blended[1]].may_pass));
    return side;
}

SurfaceSide SurfaceTable::back_of(const SceneMaterial& m, const SurfaceSide& front) const {
    if (m.back >= 0) return sides_[number(static_cast<std::uint32_t>(m.back), true)];
    SurfaceSide side = front;
    if (front.material.transmits()) {
        side.material.from_inside = true;
        if (!m.thin) side.material.eta = 1.0F / side.material.eta;
    } else if (front.blend() && !m.two_sided) {
        for (std::size_t& blended : side.blended) ++blended;
        side.may_pass = sides_[side.blended[0]].may_pass || sides_[side.blended[1]].may_pass;
    } else if (m.model != MATERIAL_PASS) {
        side.material.absorbs = !m.two_sided;
    }
    return side;
}

SurfaceMaterial SurfaceTable::at(const SurfaceSide& side, const TexturePoint& point) const {
    SurfaceMaterial material = side.material;
    const SceneMaterial& m = *side.source;
    const auto colour = [&](int index) { return glm::vec3(look_up(texture(index), point.uv, point.colour)); };
    if (m.albedo_texture != no_texture) material.albedo *= colour(m.albedo_texture);
    if (m.specular_texture != no_texture) material.specular *= colour(m.specular_texture);
    if (m.transmitted_texture != no_texture) material.transmitted *= colour(m.transmitted_texture);
    // Not smooth where a texture of roughness happens to be black: what is a delta lobe must not change from point to point.
    if (m.alpha_texture != no_texture && !material.smooth()) material.alpha = glm::max(material.alpha * colour(m.alpha_texture).x, 1e-4F);
    if (m.principled.metallic_texture != no_texture)
        material.principled.metallic = std::clamp(material.principled.metallic * colour(m.principled.metallic_texture).x, 0.0F, 1.0F);
    return material;
}

float SurfaceTable::blend_weight(const SurfaceSide& side, const TexturePoint& point) const {
    const SceneMaterial& m = *side.source;
    if (m.weight_texture == no_texture) return m.weight;
    const glm::vec4 value = look_up(texture(m.weight_texture), point.uv, point.colour);
    return std::clamp(m.weight * (m.weight_is_opacity ? value.w : value.x), 0.0F, 1.0F);
}

bool SurfaceTable::has_relief(std::size_t number) const {
    const SurfaceSide& of = side(number);
    return of.relief || (of.blend() && (has_relief(of.blended[0]) || has_relief(of.blended[1])));
}

}  // namespace pencil
