// Light sampling: which emitter, and where on it.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "reference/ray_scene.h"

namespace pencil {

/// A point on an emitter.
struct EmitterSample {
    glm::vec3 point;
    glm::vec3 normal;   // of the emitting side; zero for a point light
    float offset = 0;   // as RayHit::offset
    glm::vec3 emitted;  // radiance, or radiant intensity of a point light [scene units]
    float density = 0;  // probability per area [1 / scene units^2], or the probability of choosing this point light
    bool is_point = false;
};

/// Triangles and point lights, chosen in proportion to their power, uniformly by area within a triangle.
class Emitters {
public:
    /// Also writes SurfaceEmission::light_density.
    Emitters(const Scene& scene, RayScene& ray_scene);

    bool empty() const { return up_to_.empty(); }
    /// `u` in [0, 1)^2. There must be an emitter.
    EmitterSample sample(glm::dvec2 u) const;

private:
    struct PointEmitter {
        glm::vec3 position, intensity;
        float probability;
    };
    EmitterSample sample_triangle(std::uint32_t triangle, const glm::dvec2& u) const;

    const RayScene& ray_scene_;
    std::vector<std::uint32_t> triangles_;  // emitting ones, before the point lights in `up_to_`
    std::vector<PointEmitter> points_;
    std::vector<double> up_to_;  // power of the emitters up to and with this one, the last is 1
};

}  // namespace pencil
