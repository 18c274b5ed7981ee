#include "pencils/material_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "pencils/varnish_table.h"
#include "scene/light_unit.h"
#include "scene/texture_lookup.h"

namespace pencil {

namespace {

int flags_of(const SceneMaterial& m) {
    return (m.beckmann ? MATERIAL_BECKMANN : 0) | (m.nonlinear ? MATERIAL_NONLINEAR : 0) | (m.thin ? MATERIAL_THIN : 0) |
           (m.perfect_mirror ? MATERIAL_MIRROR : 0) | (m.bump ? MATERIAL_BUMP : 0) | (m.weight_is_opacity ? MATERIAL_OPACITY : 0) |
           (m.y_against_v ? MATERIAL_Y_UP : 0);
}

void set_textures(const SceneMaterial& m, Material& row) {
    row.albedo_texture = m.albedo_texture;
    row.specular_texture = m.specular_texture;
    row.alpha_texture = m.alpha_texture;
    row.weight_texture = m.weight_texture;
    row.normal_texture = m.normal_texture;
    row.metallic_texture = m.principled.metallic_texture;
    row.emission_texture = no_texture;
}

Material scattering(const SceneMaterial& m) {
    Material row{};
    const bool principled = m.model == MATERIAL_PRINCIPLED;
    row.model = m.model;
    row.albedo = float4(m.model == MATERIAL_PASS ? glm::vec3(0) : m.albedo, 0.0F);
    row.specular = float4(m.specular, std::sqrt(m.alpha.x * m.alpha.y));
    row.transmitted = float4(m.transmitted, 0.0F);
    row.eta = float4(m.eta, m.exponent);
    row.k = float4(m.k, 0.0F);
    const PrincipledParameters& p = m.principled;
    if (principled) {
        row.k = float4(p.sheen, p.sheen_tint, p.spec_tint, 0.0F);
        row.eta.w = p.flatness;
    }
    const glm::vec3 parameters = principled ? glm::vec3(p.metallic, p.spec_trans, p.clearcoat) : m.parameters;
    for (int k = 0; k < 3; ++k) row.parameters[k] = parameters[k];
    row.gloss = p.clearcoat_gloss;
    row.flags = flags_of(m);
    row.back = row.first = row.second = -1;
    row.weight = m.weight;
    set_textures(m, row);
    return row;
}

int wrap_of(Texture::Wrap wrap) {
    return wrap == Texture::Wrap::repeat ? TEXTURE_REPEAT : wrap == Texture::Wrap::mirror ? TEXTURE_MIRROR : TEXTURE_CLAMP;
}

std::uint64_t packed(const glm::u16vec4& texel) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &texel, sizeof bits);
    return bits;
}

}  // namespace

/// True if some light goes on unturned behind the surface.
bool MaterialRows::lets_light_pass(const SceneMaterial& m) const {
    if (m.model == MATERIAL_PASS || (m.model == MATERIAL_DIELECTRIC && m.thin)) return true;
    if (m.model != MATERIAL_BLEND) return false;
    return lets_light_pass(scene_.materials[static_cast<std::size_t>(m.blended[0])]) ||
           lets_light_pass(scene_.materials[static_cast<std::size_t>(m.blended[1])]);
}

int MaterialRows::row(std::size_t material, std::int64_t emitter, bool two_sided) {
    const SceneMaterial& m = scene_.materials[material];
    two_sided = two_sided || m.two_sided;
    const auto key = std::make_tuple(material, emitter, two_sided);
    if (const auto place = made_.find(key); place != made_.end()) return place->second;
    Material made = scattering(m);
    made.transmitted.w = m.bump_scale / static_cast<float>(scale_);
    if (m.model == MATERIAL_PLASTIC) {
        const VarnishTable table = add_varnish_table(m, texels_);
        made.varnish = table.first;
        made.k = float4(table.alpha, table.by_row, 0.0F, 0.0F);
    }
    made.albedo.w = two_sided ? 1.0F : 0.0F;
    if (m.model == MATERIAL_BLEND) {
        made.first = row(static_cast<std::size_t>(m.blended[0]), emitter, two_sided);
        made.second = row(static_cast<std::size_t>(m.blended[1]), emitter, two_sided);
    }
    if (m.back >= 0 && m.back != static_cast<std::int64_t>(material)) made.back = row(static_cast<std::size_t>(m.back), emitter, true);
    if (lets_light_pass(m)) made.flags |= MATERIAL_CLEAR;
    if (emitter >= 0) {
        const Shape& shape = scene_.shapes[static_cast<std::size_t>(emitter)];
        const bool carried = forms_[static_cast<std::size_t>(emitter)] == LightForm::maps;
        made.emission = float4(in_light_unit(mean_radiance(scene_, shape), light_), carried ? 1.0F : 0.0F);
        made.glow = float4(in_light_unit(shape.radiance, light_), 0.0F);
        made.emission_texture = shape.radiance_texture;
    }
    const int index = static_cast<int>(rows_.size());
    rows_.push_back(made);
    shapes_.push_back(static_cast<int>(emitter));
    made_[key] = index;
    return index;
}

std::vector<TextureRow> flatten_textures(const Scene& scene, std::vector<std::uint64_t>& texels) {
    std::vector<TextureRow> rows;
    for (const Texture& texture : scene.textures) {
        TextureRow row{};
        const glm::dmat3& m = texture.to_uv;
        row.row_u = float4(static_cast<float>(m[0][0]), static_cast<float>(m[1][0]), static_cast<float>(m[2][0]), 0.0F);
        row.row_v = float4(static_cast<float>(m[0][1]), static_cast<float>(m[1][1]), static_cast<float>(m[2][1]), 0.0F);
        for (int k = 0; k < 2; ++k) row.colour[k] = float4(texture.colours[k], 1.0F);
        row.kind = texture.kind == Texture::Kind::bitmap         ? TEXTURE_BITMAP
                   : texture.kind == Texture::Kind::checkerboard ? TEXTURE_CHECKERBOARD
                                                                 : TEXTURE_VERTEX_COLOURS;
        row.first = static_cast<int>(texels.size());
        row.width = texture.width;
        row.height = texture.height;
        row.wrap_u = wrap_of(texture.wrap_u);
        row.wrap_v = wrap_of(texture.wrap_v);
        row.nearest = texture.nearest ? 1 : 0;
        if (texture.kind == Texture::Kind::bitmap)
            std::transform(texture.texels.begin(), texture.texels.end(), std::back_inserter(texels), packed);
        rows.push_back(row);
    }
    return rows;
}

}  // namespace pencil
