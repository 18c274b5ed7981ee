// The surface that a ray met, as the path needs it: how it scatters between directions of the world. Two kinds: of scenes where all is
// diffuse and of one colour, which cost as little as possible, and any.
#pragma once

#include "reference/bsdf.h"
#include "reference/ray_scene.h"
#include "reference/sampler.h"
#include "reference/shading_frame.h"

namespace pencil {

/// In a plain scene (SurfaceTable::plain). The frame is made where it is asked for: what is not needed costs nothing (8 % of a path's time).
class DiffuseSurface {
public:
    static constexpr bool plain = true;
    DiffuseSurface(const RayScene& scene, const RayHit& hit, const glm::vec3&, Sampler&)
        : material_(scene.surfaces().side(SurfaceTable::number(hit.material, hit.front)).material), hit_(hit) {}

    bool absorbs() const { return material_.absorbs || material_.albedo == glm::vec3(0.0F); }
    bool may_pass() const { return false; }
    bool only_delta() const { return false; }
    const glm::vec3& normal() const { return hit_.shading; }
    glm::vec3 albedo() const { return material_.absorbs ? glm::vec3(0.0F) : material_.albedo; }

    glm::vec3 to_local(const glm::vec3& v) const { return ShadingFrame(hit_.shading).to_local(v); }
    glm::vec3 to_world(const glm::vec3& v) const { return ShadingFrame(hit_.shading).to_world(v); }
    /// Whether light can come from `omega_i`, which is `direction` of the world.
    bool faces(const glm::vec3& omega_i, const glm::vec3& direction) const {
        return omega_i.z > 0.0F && glm::dot(hit_.normal, direction) > 0.0F;
    }
    glm::vec3 evaluate(const glm::vec3& omega_i) const { return material_.albedo * (inverse_pi * omega_i.z); }
    float pdf(const glm::vec3& omega_i) const { return inverse_pi * omega_i.z; }
    BsdfSample sample(const glm::dvec2& u, Sampler&) const { return sample_diffuse(material_, glm::vec3(0.0F), u, 0.0); }

private:
    const SurfaceMaterial& material_;
    const RayHit& hit_;
};

/// White and diffuse, whatever stands there: its radiance is irradiance / pi.
class WhiteReceiver {
public:
    static constexpr bool plain = true;
    explicit WhiteReceiver(const RayHit& hit) : hit_(hit), frame_(hit.shading) {}

    glm::vec3 to_local(const glm::vec3& v) const { return frame_.to_local(v); }
    glm::vec3 to_world(const glm::vec3& v) const { return frame_.to_world(v); }
    bool faces(const glm::vec3& omega_i, const glm::vec3& direction) const {
        return omega_i.z > 0.0F && glm::dot(hit_.normal, direction) > 0.0F;
    }
    glm::vec3 evaluate(const glm::vec3& omega_i) const { return glm::vec3(inverse_pi * omega_i.z); }
    float pdf(const glm::vec3& omega_i) const { return inverse_pi * omega_i.z; }

private:
    const RayHit& hit_;
    ShadingFrame frame_;
};

/// Of any material. Blends are resolved at random.
class ScatteringSurface {
public:
    static constexpr bool plain = false;
    /// `direction`: of the ray.
    ScatteringSurface(const RayScene& scene, const RayHit& hit, const glm::vec3& direction, Sampler& sampler);

    bool absorbs() const { return absorbs_; }
    bool may_pass() const { return material_.model == MATERIAL_PASS || (material_.model == MATERIAL_DIELECTRIC && material_.thin); }
    bool only_delta() const { return pencil::only_delta(material_); }
    const glm::vec3& normal() const { return frame_.normal(); }
    glm::vec3 albedo() const { return absorbs_ ? glm::vec3(0.0F) : pencil::albedo(material_, omega_o_); }

    glm::vec3 to_local(const glm::vec3& v) const { return frame_.to_local(v); }
    glm::vec3 to_world(const glm::vec3& v) const { return frame_.to_world(v); }
    /// The shading and the true normal agree on the side, or light would leak.
    bool faces(const glm::vec3& omega_i, const glm::vec3& direction) const {
        return (omega_i.z > 0.0F) == (glm::dot(hit_.normal, direction) > 0.0F);
    }
    glm::vec3 evaluate(const glm::vec3& omega_i) const { return pencil::evaluate(material_, omega_o_, omega_i); }
    float pdf(const glm::vec3& omega_i) const { return pencil::pdf(material_, omega_o_, omega_i); }
    BsdfSample sample(const glm::dvec2& u, Sampler& sampler) const {
        // A pair of its own, though only half of it is used: choices between lobes gain from stratification.
        const double lobe = material_.model == MATERIAL_DIFFUSE || material_.model == MATERIAL_CONDUCTOR ? 0.0 : sampler.next_2d().x;
        return pencil::sample(material_, omega_o_, u, lobe);
    }

private:
    const RayHit& hit_;
    SurfaceMaterial material_;
    ShadingFrame frame_;
    glm::vec3 omega_o_;
    bool absorbs_;
};

/// Share of light that goes on unturned through the surface at `hit`.
glm::vec3 straight_transmittance(const RayScene& scene, const RayHit& hit, const glm::vec3& direction);

}  // namespace pencil
