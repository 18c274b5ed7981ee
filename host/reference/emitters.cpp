#include "reference/emitters.h"

#include <algorithm>

namespace pencil {
namespace {

constexpr double pi = 3.14159265358979323846;

double mean(const glm::vec3& rgb) { return (static_cast<double>(rgb.x) + rgb.y + rgb.z) / 3; }

double area(const RayTriangle& t) { return 0.5 * glm::length(glm::cross(glm::dvec3(t.edge1), glm::dvec3(t.edge2))); }

/// Low-distortion map of the unit square to barycentric coordinates (Heitz 2019), here without its branch.
glm::dvec2 square_to_triangle(const glm::dvec2& u) { return u - 0.5 * std::min(u.x, u.y); }

}  // namespace

Emitters::Emitters(const Scene& scene, RayScene& ray_scene) : ray_scene_(ray_scene) {
    double total = 0;
    for (std::size_t i = 0; i < ray_scene.triangles().size(); ++i) {
        const RayTriangle& t = ray_scene.triangles()[i];
        const double power = pi * area(t) * mean(ray_scene.emission()[t.shape].radiance);
        if (!(power > 0)) continue;
        triangles_.push_back(static_cast<std::uint32_t>(i));
        up_to_.push_back(total += power);
    }
    for (const PointLight& light : scene.point_lights) {
        const glm::dvec3 intensity = glm::dvec3(light.intensity) / (ray_scene.scale() * ray_scene.scale());
        const double power = 4 * pi * mean(intensity);
        if (!(power > 0)) continue;
        points_.push_back({ray_scene.to_scene(light.position), intensity, static_cast<float>(power)});
        up_to_.push_back(total += power);
    }
    if (empty()) return;
    for (double& value : up_to_) value /= total;
    for (PointEmitter& point : points_) point.probability = static_cast<float>(point.probability / total);
    for (SurfaceEmission& emission : ray_scene.emission())
        emission.light_density = static_cast<float>(pi * mean(emission.radiance) / total);
}

EmitterSample Emitters::sample(glm::dvec2 u) const {
    const auto found = std::upper_bound(up_to_.begin(), up_to_.end() - 1, u.x);
    const auto chosen = static_cast<std::size_t>(found - up_to_.begin());
    if (chosen >= triangles_.size()) {
        const PointEmitter& point = points_[chosen - triangles_.size()];
        return {point.position, glm::vec3(0.0F), 0.0F, point.intensity, point.probability, true};
    }
    // The part of the interval that chose the triangle is used again within it.
    const double below = chosen == 0 ? 0.0 : up_to_[chosen - 1];
    u.x = std::min((u.x - below) / (*found - below), 0x1.fffffffffffffp-1);
    return sample_triangle(triangles_[chosen], u);
}

EmitterSample Emitters::sample_triangle(std::uint32_t triangle, const glm::dvec2& u) const {
    const RayTriangle& t = ray_scene_.triangles()[triangle];
    const SurfaceEmission& emission = ray_scene_.emission()[t.shape];
    const glm::vec2 b(square_to_triangle(u));
    return {t.corner + b.x * t.edge1 + b.y * t.edge2, t.normal, t.offset, emission.radiance, emission.light_density, false};
}

}  // namespace pencil
