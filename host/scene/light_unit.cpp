#include "scene/light_unit.h"

#include <algorithm>
#include <cmath>

#include "scene/texture_lookup.h"

namespace pencil {

namespace {

double largest(const glm::dvec3& rgb) { return std::max({rgb.x, rgb.y, rgb.z}); }

/// Of the box about all points and point lights [world units]; 1 if it is a point.
double extent(const Scene& scene) {
    glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
    const auto grow = [&](const glm::dvec3& p) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    };
    for (const glm::dvec3& p : scene.positions) grow(p);
    for (const PointLight& light : scene.point_lights) grow(light.position);
    const glm::dvec3 size = high - low;
    const double widest = std::max({size.x, size.y, size.z});
    return widest > 0 ? widest : 1.0;
}

double strongest(const Environment& environment) {
    double texel = environment.is_map() ? 0.0 : 1.0;
    for (const glm::vec3& t : environment.texels) texel = std::max(texel, largest(t));
    return largest(environment.radiance) * texel;
}

}  // namespace

double light_unit(const Scene& scene) {
    double strength = scene.environment ? strongest(*scene.environment) : 0.0;
    for (const Shape& shape : scene.shapes)
        if (shape.emits) strength = std::max(strength, largest(mean_radiance(scene, shape)));
    for (const DirectionalLight& light : scene.directional_lights) strength = std::max(strength, largest(light.irradiance));
    const double width = scene.point_lights.empty() ? 1.0 : extent(scene);
    for (const PointLight& light : scene.point_lights) strength = std::max(strength, largest(light.intensity) / width / width);
    return strength > 0 && std::isfinite(strength) ? std::ldexp(1.0, std::ilogb(strength)) : 1.0;
}

}  // namespace pencil
