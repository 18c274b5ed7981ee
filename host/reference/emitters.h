// Light sampling: which emitter, and where on it.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "reference/environment_light.h"
#include "reference/ray_scene.h"

namespace pencil {

/// A point on an emitter, or the direction to one that is infinitely far away.
struct EmitterSample {
    glm::vec3 point;    // or unit direction
    glm::vec3 normal;   // of the emitting side; zero for a point light and what is far away
    float offset = 0;   // as RayHit::offset
    glm::vec3 emitted;  // radiance, radiant intensity of a point light [scene units], irradiance of parallel light
    float density = 0;  // probability per area [1 / scene units^2], per solid angle if far away, or of choosing this light
    bool one_point = false, far_away = false;  // one_point: no other sample of this light is possible
};

/// Triangles and point lights, chosen mostly in proportion to their power, uniformly by area within a triangle; and light from far away, by its flux.
/// If there are both, each has half of the samples: how much of what is far away comes in is not known.
class Emitters {
public:
    /// Also writes SurfaceEmission::light_density. The scene must outlive this.
    Emitters(const Scene& scene, RayScene& ray_scene);

    bool empty() const { return up_to_.empty() && far_up_to_.empty(); }
    /// `u` in [0, 1)^2. There must be an emitter. `from`: the point that is lit.
    EmitterSample sample(glm::dvec2 u, const glm::vec3& from) const;

    const EnvironmentLight* environment() const { return environment_ ? &*environment_ : nullptr; }
    /// With which `sample` chooses a unit direction of the environment [1/sr].
    float environment_density(const glm::vec3& direction) const { return environment_share_ * environment_->density(direction); }

private:
    struct PointEmitter {
        glm::vec3 position, intensity;
        float probability;
        const PointLight* shaped;  // if it does not send the same everywhere
        glm::dmat3 to_local;
    };
    struct FarEmitter {
        glm::vec3 direction, irradiance;  // to the light
        float probability;
    };
    void add_finite(const Scene& scene);
    void add_far(const Scene& scene);
    EmitterSample sample_triangle(std::uint32_t triangle, const glm::dvec2& u) const;
    EmitterSample sample_point(const PointEmitter& point, const glm::vec3& from) const;
    EmitterSample sample_far(glm::dvec2 u) const;

    RayScene& ray_scene_;
    const std::vector<LightProfile>& profiles_;
    std::vector<std::uint32_t> triangles_;  // emitting ones, before the point lights in `up_to_`
    std::vector<PointEmitter> points_;
    std::vector<double> up_to_;  // chances of the emitters up to and with this one
    std::optional<EnvironmentLight> environment_;
    std::vector<FarEmitter> parallel_;
    std::vector<double> far_up_to_;  // parallel lights, then the environment
    double far_share_ = 0;           // of the samples
    float environment_share_ = 0;    // of the samples
};

}  // namespace pencil
