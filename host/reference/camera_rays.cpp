#include "reference/camera_rays.h"

#include <algorithm>
#include <cmath>

namespace pencil {

CameraRays::CameraRays(const PerspectiveSensor& sensor, const RayScene& scene, int width, int height)
    : filter_(sensor.filter), near_(sensor.near_clip / scene.scale()), far_(sensor.far_clip / scene.scale()) {
    const glm::dvec3 left = glm::normalize(glm::dvec3(sensor.to_world[0])), up = glm::normalize(glm::dvec3(sensor.to_world[1])),
                     forward = glm::normalize(glm::dvec3(sensor.to_world[2]));
    const double pixel = 2 * std::tan(glm::radians(sensor.fov_x) / 2) / width;  // at unit depth
    step_x_ = -pixel * left;
    step_y_ = -pixel * up;
    corner_ = forward - step_x_ * (width * (0.5 + sensor.principal_point_offset.x)) -
              step_y_ * (height * (0.5 + sensor.principal_point_offset.y));
    eye_ = scene.to_scene(glm::dvec3(sensor.to_world[3]));
    for (int x = 0; x < width; ++x) columns_.push_back(filter_.range(-x - 0.5, width - x - 0.5));
    for (int y = 0; y < height; ++y) rows_.push_back(filter_.range(-y - 0.5, height - y - 0.5));
    // A margin of some rounding errors, so that walls of the box are met.
    low_ = scene.low() - 1e-5;
    high_ = scene.high() + 1e-5;
}

CameraRays::Sample CameraRays::sample(int x, int y, const glm::dvec2& u) const {
    const FilterSampler::Sample px = filter_.sample(columns_[static_cast<std::size_t>(x)], u.x),
                                py = filter_.sample(rows_[static_cast<std::size_t>(y)], u.y);
    const glm::dvec3 direction = corner_ + (x + 0.5 + px.offset) * step_x_ + (y + 0.5 + py.offset) * step_y_;
    Sample sample;
    sample.weight = px.weight * py.weight;
    // From where the ray enters the scene's box, in double precision: a camera far away loses no digits.
    double begin = near_, end = far_;
    for (int k = 0; k < 3; ++k) {
        const double inverse = 1 / direction[k], a = (low_[k] - eye_[k]) * inverse, b = (high_[k] - eye_[k]) * inverse;
        begin = std::max(begin, std::min(a, b));  // 0 * infinity compares false and leaves the interval as it is
        end = std::min(end, std::max(a, b));
    }
    sample.meets = begin < end;
    if (sample.meets) sample.ray = {glm::vec3(eye_ + begin * direction), glm::vec3(direction), static_cast<float>(end - begin)};
    return sample;
}

}  // namespace pencil
