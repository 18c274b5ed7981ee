// One light path: from a camera ray through reflections to emitters.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "reference/brdf.h"
#include "reference/emitters.h"
#include "reference/ray_scene.h"
#include "reference/sampler.h"

namespace pencil {

/// Orders of reflection that are kept apart: 0 emission, 1 direct light, up to most_orders - 2; the last holds all beyond.
constexpr int most_orders = 17;

/// Sums over paths.
struct PathSums {
    std::array<glm::vec3, most_orders> radiance{};
    int orders = 0;  // of `radiance` that hold something
    std::uint64_t rays = 0;
    std::uint64_t dropped = 0;  // contributions that were no finite numbers
    std::uint64_t cut = 0;      // paths that were ended because they were too long
};

/// How a surface reflects light back along a ray that met it. Frame and omega_o are made where they are asked for: what a model does not
/// need costs nothing (8 % of a path's time with the diffuse one).
struct Reflection {
    const SurfaceMaterial& material;
    const glm::vec3 &normal, &ray_direction;

    ShadingFrame frame() const { return ShadingFrame(normal); }
    glm::vec3 omega_o() const { return -glm::normalize(frame().to_local(ray_direction)); }
};

class PathIntegrator {
public:
    PathIntegrator(const RayScene& scene, const Emitters& emitters, int max_depth)
        : scene_(scene), emitters_(emitters), max_depth_(max_depth) {}

    /// Adds `weight` times what arrives at the camera from the surface point that its ray met.
    void trace(const Ray& camera_ray, const RayHit& first, float weight, Sampler& sampler, PathSums& sums) const;

private:
    glm::vec3 direct_light(const RayHit& hit, const Reflection& reflection, const glm::dvec2& u, PathSums& sums) const;

    const RayScene& scene_;
    const Emitters& emitters_;
    int max_depth_;
};

}  // namespace pencil
