// One light path: from a camera ray through reflections to emitters.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

#include "reference/emitters.h"
#include "reference/ray_scene.h"
#include "reference/sampler.h"
#include "reference/surface_sums.h"

namespace pencil {

/// Orders of reflection that are kept apart: 0 emission, 1 direct light, up to most_orders - 2; the last holds all beyond. Refraction counts
/// as reflection; light that goes on unturned does not.
constexpr int most_orders = 17;

/// Sums over paths.
struct PathSums {
    std::array<glm::vec3, most_orders> radiance{};
    int orders = 0;  // of `radiance` that hold something
    std::uint64_t rays = 0;
    std::uint64_t dropped = 0;  // contributions that were no finite numbers
    std::uint64_t cut = 0;      // paths that were ended because they were too long
};

class PathIntegrator {
public:
    PathIntegrator(const RayScene& scene, const Emitters& emitters, int max_depth)
        : scene_(scene), emitters_(emitters), max_depth_(max_depth) {}

    /// Adds `weight` times what arrives at the camera along its ray. `inside`: the ray enters the box of the scene. `seen`, if not null, gets
    /// the first surface that does not let the path through.
    void trace(const Ray& camera_ray, bool inside, float weight, Sampler& sampler, PathSums& sums, SurfaceSums* seen) const;

    /// Adds `weight` times irradiance / pi at a point: what a white diffuse surface sends that is not there for anyone else. Of `at` its point,
    /// normals and offset count.
    void trace_receiver(const RayHit& at, float weight, Sampler& sampler, PathSums& sums) const;
    /// The same of the first surface that a camera ray meets, if any: as a meter that is laid there faces. In scenes with relief that is as the
    /// triangle does.
    void trace_received(const Ray& camera_ray, bool inside, float weight, Sampler& sampler, PathSums& sums) const;

private:
    /// How a path begins: at the camera, or at a receiver, whose ray has a density per solid angle.
    struct Start {
        Ray ray;
        bool inside = true;
        int depth = 1;
        float density = 0;
    };
    template <typename Surface>
    void trace_among(const Start& start, float weight, Sampler& sampler, PathSums& sums, SurfaceSums* seen) const;
    template <typename Surface>
    void receive(const RayHit& at, float weight, Sampler& sampler, PathSums& sums) const;
    template <typename Surface, typename Vertex>
    glm::vec3 direct_light(const RayHit& hit, const Vertex& surface, const glm::dvec2& u, PathSums& sums) const;
    template <typename Surface>
    glm::vec3 transmittance(const Ray& ray, PathSums& sums) const;

    const RayScene& scene_;
    const Emitters& emitters_;
    int max_depth_;
};

}  // namespace pencil
