#include "scene/default_view.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

#include "util/constants.h"

namespace pencil {
namespace {

struct Box {
    glm::dvec3 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};

    glm::dvec3 corner(int i) const { return {(i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z}; }
};

Box box_of(const Scene& scene) {
    Box box;
    for (const glm::dvec3& position : scene.positions) {
        box.low = glm::min(box.low, position);
        box.high = glm::max(box.high, position);
    }
    return box;
}

/// Displays and eyes of models, say; lamps shine brighter than the white of a screen, or evenly.
bool only_pictures_glow(const Scene& scene) {
    if (scene.environment || !scene.point_lights.empty() || !scene.directional_lights.empty()) return false;
    return std::none_of(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) {
        const float strongest = std::max({shape.radiance.x, shape.radiance.y, shape.radiance.z});
        return shape.emits && shape.triangle_count > 0 && strongest > (shape.radiance_texture == no_texture ? 0.0F : 1.0F);
    });
}

}  // namespace

void frame_scene(Scene& scene) {
    constexpr double margin = 1.05, far_away = 1e4;  // far_away: in terms of the distance
    const Box box = box_of(scene);
    const glm::dvec3 middle = 0.5 * (box.low + box.high), forward = glm::normalize(glm::dvec3(-0.6, -0.45, -0.8));
    const glm::dvec3 left = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), forward)), up = glm::cross(forward, left);
    PerspectiveSensor sensor;
    sensor.fov_x = 40;
    const double across = std::tan(glm::radians(sensor.fov_x / 2)), along = across * sensor.height / sensor.width;
    double distance = 0;
    for (int i = 0; i < 8; ++i) {  // each corner asks for a distance at which it comes into view
        const glm::dvec3 corner = box.corner(i) - middle;
        const double aside = std::abs(glm::dot(corner, left)) / across, above = std::abs(glm::dot(corner, up)) / along;
        distance = std::max(distance, margin * std::max(aside, above) - glm::dot(corner, forward));
    }
    sensor.to_world =
        glm::dmat4(glm::dvec4(left, 0), glm::dvec4(up, 0), glm::dvec4(forward, 0), glm::dvec4(middle - distance * forward, 1));
    sensor.near_clip = distance / far_away;
    sensor.far_clip = distance * far_away;
    scene.sensor = sensor;
}

bool has_light(const Scene& scene) {
    const auto emits = [](const Shape& shape) { return shape.emits && shape.triangle_count > 0 && shape.radiance != glm::vec3(0.0F); };
    return scene.environment || !scene.point_lights.empty() || !scene.directional_lights.empty() ||
           std::any_of(scene.shapes.begin(), scene.shapes.end(), emits);
}

Environment default_sky() {
    const glm::vec3 zenith(0.55F, 0.75F, 1.1F), horizon(1.1F, 1.1F, 1.1F), ground(0.45F, 0.42F, 0.4F);
    Environment sky;
    sky.width = 32;
    sky.height = 16;
    for (int row = 0; row < sky.height; ++row) {
        const auto height = static_cast<float>(std::cos(pi * (row + 0.5) / sky.height));  // of the direction: 1 above, -1 below
        const glm::vec3 colour = height > 0 ? glm::mix(horizon, zenith, std::sqrt(height)) : ground;
        sky.texels.insert(sky.texels.end(), static_cast<std::size_t>(sky.width), colour);
    }
    return sky;
}

void complete_scene(Scene& scene, bool has_sensor, const std::string& where) {
    if (!has_sensor) {
        frame_scene(scene);
        scene.warnings.push_back(where + ": there is no camera; the view shows the whole scene from the front right and above");
    }
    if (has_light(scene) && !only_pictures_glow(scene)) return;
    const bool glows = has_light(scene);
    scene.environment = default_sky();
    scene.warnings.push_back(where + (glows ? ": only pictures on surfaces glow, and nothing else gives light; a clear sky is added"
                                            : ": there is no light; a clear sky is added"));
}

}  // namespace pencil
