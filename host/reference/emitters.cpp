#include "reference/emitters.h"

#include <algorithm>

#include "reference/lamp.h"
#include "scene/light_chances.h"
#include "scene/light_unit.h"
#include "scene/texture_lookup.h"
#include "util/constants.h"

namespace pencil {
namespace {

constexpr double below_one = 0x1.fffffffffffffp-1;

double mean(const glm::vec3& rgb) { return (static_cast<double>(rgb.x) + rgb.y + rgb.z) / 3; }

double area(const RayTriangle& t) { return 0.5 * glm::length(glm::cross(glm::dvec3(t.edge1), glm::dvec3(t.edge2))); }

/// Low-distortion map of the unit square to barycentric coordinates (Heitz 2019), here without its branch.
glm::dvec2 square_to_triangle(const glm::dvec2& u) { return u - 0.5 * std::min(u.x, u.y); }

/// The part of the interval that chose one of many is used again within it.
std::size_t choose(const std::vector<double>& up_to, double& u) {
    const auto found = std::upper_bound(up_to.begin(), up_to.end() - 1, u);
    const auto chosen = static_cast<std::size_t>(found - up_to.begin());
    const double below = chosen == 0 ? 0.0 : up_to[chosen - 1];
    u = std::min((u - below) / (*found - below), below_one);
    return chosen;
}

std::vector<double> shape_powers(const RayScene& scene, const std::vector<double>& means) {
    std::vector<double> powers(means.size(), 0.0);
    for (const RayTriangle& t : scene.triangles()) powers[t.shape] += pi * area(t) * means[t.shape];
    return powers;
}

glm::dvec3 intensity_of(const PointLight& light, const RayScene& scene) {
    return glm::dvec3(light.intensity) / (scene.scale() * scene.scale()) / scene.light();
}

/// True if it does not send the same everywhere.
bool is_shaped(const PointLight& light) { return light.is_spot || light.profile >= 0; }

std::vector<double> point_powers(const Scene& scene, const RayScene& ray_scene) {
    std::vector<double> powers;
    for (const PointLight& light : scene.point_lights)
        powers.push_back((is_shaped(light) ? lamp_extent(light, scene.profiles) : 4 * pi) * mean(intensity_of(light, ray_scene)));
    return powers;
}

}  // namespace

Emitters::Emitters(const Scene& scene, RayScene& ray_scene) : ray_scene_(ray_scene), profiles_(scene.profiles) {
    add_far(scene);
    add_finite(scene);
}

void Emitters::add_finite(const Scene& scene) {
    std::vector<double> means;  // of radiance, by shape
    for (const SurfaceEmission& e : ray_scene_.emission())
        means.push_back(mean(e.texture == no_texture ? e.radiance : e.radiance * mean_colour(ray_scene_.surfaces().texture(e.texture))));
    const std::vector<double> of_shape = shape_powers(ray_scene_, means), of_point = point_powers(scene, ray_scene_);
    LightChances chances;
    for (const double power : of_shape) chances.add(power);
    for (const double power : of_point) chances.add(power);
    far_share_ = far_up_to_.empty() ? 0 : chances.empty() ? 1 : 0.5;
    environment_share_ *= static_cast<float>(far_share_);
    double up_to = 0;
    for (std::size_t i = 0; i < ray_scene_.triangles().size(); ++i) {
        const RayTriangle& t = ray_scene_.triangles()[i];
        const double power = pi * area(t) * means[t.shape];
        if (!(power > 0)) continue;
        triangles_.push_back(static_cast<std::uint32_t>(i));
        up_to_.push_back(up_to += power * chances.per_power(of_shape[t.shape]));
    }
    for (std::size_t i = 0; i < of_point.size(); ++i) {
        if (!(of_point[i] > 0)) continue;
        const PointLight& light = scene.point_lights[i];
        const double chance = chances.of(of_point[i]);
        points_.push_back({ray_scene_.to_scene(light.position), intensity_of(light, ray_scene_),
                           static_cast<float>(chance * (1 - far_share_)), is_shaped(light) ? &light : nullptr,
                           glm::inverse(light.to_world)});
        up_to_.push_back(up_to += chance);
    }
    for (std::size_t i = 0; i < means.size(); ++i)
        if (of_shape[i] > 0)
            ray_scene_.emission()[i].light_density = static_cast<float>(pi * means[i] * chances.per_power(of_shape[i]) * (1 - far_share_));
}

void Emitters::add_far(const Scene& scene) {
    double total = 0;
    for (const DirectionalLight& light : scene.directional_lights) {
        const glm::vec3 irradiance = in_light_unit(light.irradiance, ray_scene_.light());
        const double flux = mean(irradiance);
        if (!(flux > 0)) continue;
        parallel_.push_back({-light.direction, irradiance, static_cast<float>(flux)});
        far_up_to_.push_back(total += flux);
    }
    if (scene.environment) {
        environment_.emplace(*scene.environment, ray_scene_.light());
        if (environment_->flux() > 0)
            far_up_to_.push_back(total += environment_->flux());
        else
            environment_.reset();
    }
    for (double& value : far_up_to_) value /= total;
    for (FarEmitter& light : parallel_) light.probability /= static_cast<float>(total);
    if (environment_) environment_share_ = static_cast<float>(environment_->flux() / total);
}

EmitterSample Emitters::sample(glm::dvec2 u, const glm::vec3& from) const {
    if (far_share_ > 0) {
        if (u.x < far_share_) return sample_far({u.x / far_share_, u.y});
        u.x = std::min((u.x - far_share_) / (1 - far_share_), below_one);
    }
    const std::size_t chosen = choose(up_to_, u.x);
    if (chosen >= triangles_.size()) return sample_point(points_[chosen - triangles_.size()], from);
    return sample_triangle(triangles_[chosen], u);
}

EmitterSample Emitters::sample_triangle(std::uint32_t triangle, const glm::dvec2& u) const {
    const RayTriangle& t = ray_scene_.triangles()[triangle];
    const SurfaceEmission& emission = ray_scene_.emission()[t.shape];
    const glm::vec2 b(square_to_triangle(u));
    const glm::vec3 radiance = emission.texture == no_texture ? emission.radiance : ray_scene_.emitted(triangle, b.x, b.y);
    return {t.corner + b.x * t.edge1 + b.y * t.edge2, t.normal, t.offset, radiance, emission.light_density};
}

EmitterSample Emitters::sample_point(const PointEmitter& point, const glm::vec3& from) const {
    glm::vec3 intensity = point.intensity;
    if (point.shaped != nullptr) {
        const glm::dvec3 direction = glm::normalize(point.to_local * glm::dvec3(from - point.position));
        intensity *= static_cast<float>(lamp_factor(*point.shaped, profiles_, direction));
    }
    return {point.position, glm::vec3(0.0F), 0.0F, intensity, point.probability, true};
}

EmitterSample Emitters::sample_far(glm::dvec2 u) const {
    const std::size_t chosen = choose(far_up_to_, u.x);
    if (chosen < parallel_.size()) {
        const FarEmitter& light = parallel_[chosen];
        return {light.direction, glm::vec3(0.0F), 0.0F, light.irradiance, light.probability * static_cast<float>(far_share_), true, true};
    }
    const EnvironmentLight::Sample s = environment_->sample(u);
    return {s.direction, glm::vec3(0.0F), 0.0F, s.radiance, s.density * environment_share_, false, true};
}

}  // namespace pencil
