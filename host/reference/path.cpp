// Next-event estimation and BRDF sampling, combined by the power heuristic (Veach 1997, 9.2).
#include "reference/path.h"

#include <algorithm>
#include <cmath>

namespace pencil {
namespace {

constexpr float pi = 3.14159265F;
/// Paths shorter than this are not ended at random: they carry most of the light.
constexpr int sure_depth = 4;
/// Where nothing is lost paths would never end.
constexpr int longest_path = 1 << 16;

float power_heuristic(float density, float other) {
    const float ratio = other / density;
    return 1.0F / (1.0F + ratio * ratio);
}

/// The hit point, moved to the side of `normal` further than its rounding error.
glm::vec3 off_surface(const glm::vec3& point, const glm::vec3& normal, float offset) { return point + offset * normal; }

void record(PathSums& sums, int order, const glm::vec3& radiance) {
    if (!(std::abs(radiance.x) + std::abs(radiance.y) + std::abs(radiance.z) <= std::numeric_limits<float>::max())) {
        ++sums.dropped;
        return;
    }
    const int slot = std::min(order, most_orders - 1);
    sums.radiance[static_cast<std::size_t>(slot)] += radiance;
    sums.orders = std::max(sums.orders, slot + 1);
}

}  // namespace

/// Radiance that the surface at `hit` reflects of one light sample.
glm::vec3 PathIntegrator::direct_light(const RayHit& hit, const Reflection& reflection, const glm::dvec2& u, PathSums& sums) const {
    const EmitterSample light = emitters_.sample(u);
    const glm::vec3 segment = light.point - hit.point;
    const float square = glm::dot(segment, segment), inverse = 1.0F / std::sqrt(square);
    const glm::vec3 omega_i = reflection.frame().to_local(segment) * inverse;
    const float cosine = omega_i.z;
    if (!(cosine > 0.0F) || !(glm::dot(hit.normal, segment) > 0.0F)) return glm::vec3(0.0F);
    const SurfaceMaterial& material = reflection.material;
    glm::vec3 radiance = light.emitted * (cosine / (pi * light.density * square)) * evaluate(material, reflection.omega_o(), omega_i);
    if (!light.is_point) {
        const float light_cosine = -glm::dot(light.normal, segment) * inverse;
        if (!(light_cosine > 0.0F)) return glm::vec3(0.0F);
        radiance *=
            light_cosine * power_heuristic(light.density * square, pdf(material, reflection.omega_o(), omega_i) * light_cosine / pi);
    }
    const glm::vec3 from = off_surface(hit.point, hit.normal, hit.offset), to = off_surface(light.point, light.normal, light.offset);
    ++sums.rays;
    return scene_.occluded({from, to - from, 1.0F}) ? glm::vec3(0.0F) : radiance;
}

void PathIntegrator::trace(const Ray& camera_ray, const RayHit& first, float weight, Sampler& sampler, PathSums& sums) const {
    Ray ray = camera_ray;
    RayHit hit = first;
    glm::vec3 throughput(1.0F);
    float density = 0;  // per solid angle, with which the BRDF chose the ray
    for (int depth = 1;; ++depth) {
        const SurfaceEmission& emission = scene_.emission()[hit.shape];
        if (hit.front && emission.light_density > 0.0F) {
            float share = 1.0F;
            if (depth > 1) {
                const float length = glm::length(ray.direction) * hit.distance, cosine = -glm::dot(hit.normal, ray.direction);
                share = power_heuristic(density, emission.light_density * length * length / cosine);
            }
            record(sums, depth - 1, weight * share * throughput * emission.radiance);
        }
        const SurfaceMaterial& material = scene_.materials()[hit.material];
        if (depth == max_depth_ || !(hit.front || material.two_sided)) return;
        const Reflection reflection{material, hit.shading, ray.direction};
        if (albedo(material, reflection.omega_o()) == glm::vec3(0.0F)) return;
        const glm::dvec2 light_u = sampler.next_2d(), brdf_u = sampler.next_2d();
        if (!emitters_.empty()) record(sums, depth, weight * throughput * direct_light(hit, reflection, light_u, sums));

        const BrdfSample chosen = sample(material, reflection.omega_o(), brdf_u);
        const glm::vec3 direction = reflection.frame().to_world(chosen.omega_i);
        if (!(chosen.pdf > 0.0F && glm::dot(direction, hit.normal) > 0.0F)) return;
        throughput *= chosen.weight;
        density = chosen.pdf / pi;
        if (depth >= sure_depth) {
            // No cap below 1: dividing by less than was lost makes weights grow without bound, and their variance.
            const float survival = std::min(std::max({throughput.x, throughput.y, throughput.z}), 1.0F);
            if (!(sampler.next_1d() < survival)) return;
            throughput /= survival;
            if (depth == longest_path) {
                ++sums.cut;
                return;
            }
        }
        ray = {off_surface(hit.point, hit.normal, hit.offset), direction};
        ++sums.rays;
        if (!scene_.intersect(ray, hit)) return;
    }
}

}  // namespace pencil
