// What the sides of a scene's materials do, before textures are looked up.
#pragma once

#include <memory>
#include <vector>

#include "reference/bsdf_types.h"
#include "reference/plastic_table.h"

namespace pencil {

/// Where on a surface, for textures.
struct TexturePoint {
    glm::vec2 uv{0.0F};
    glm::vec3 colour{1.0F};              // of the vertices
    glm::vec3 dp_du{0.0F}, dp_dv{0.0F};  // change of the point [scene units]; zero where there are no coordinates
};

/// One side of a material.
struct SurfaceSide {
    SurfaceMaterial material;
    const SceneMaterial* source = nullptr;
    std::size_t blended[2] = {0, 0};  // sides, of a blend
    bool textured = false;            // parameters of the material come from textures
    bool relief = false;              // the shading normal is turned by a texture
    bool tangents = false;            // it matters which way u runs
    bool may_pass = false;            // some light goes on unturned
    bool blend() const { return material.model == MATERIAL_BLEND; }
};

class SurfaceTable {
public:
    explicit SurfaceTable(const Scene& scene);

    const SurfaceSide& side(std::size_t number) const { return sides_[number]; }
    static std::size_t number(std::uint32_t material, bool front) { return std::size_t{2} * material + (front ? 0 : 1); }
    /// All materials are diffuse and of one colour, and so are emitters.
    bool plain() const { return plain_; }
    bool may_pass() const { return may_pass_; }
    /// The shading normal of this side, or of what it is blended from, is turned by a texture.
    bool has_relief(std::size_t number) const;

    const Texture& texture(int index) const { return textures_[static_cast<std::size_t>(index)]; }
    /// The material at a point.
    SurfaceMaterial at(const SurfaceSide& side, const TexturePoint& point) const;
    /// Probability of the second side of a blend.
    float blend_weight(const SurfaceSide& side, const TexturePoint& point) const;

private:
    SurfaceSide front_of(const SceneMaterial& material);
    SurfaceSide back_of(const SceneMaterial& material, const SurfaceSide& front) const;

    const std::vector<Texture>& textures_;
    std::vector<SurfaceSide> sides_;  // front and back of each material
    std::vector<std::unique_ptr<PlasticTable>> tables_;
    bool plain_ = true, may_pass_ = false;
};

}  // namespace pencil
