#include "scene/sensor_places.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace pencil {

namespace {

/// Normal of the front times twice the area.
glm::dvec3 area_vector(const Scene& scene, const Triangle3& t) {
    const glm::dvec3 &a = scene.positions[t.corners.x], &b = scene.positions[t.corners.y], &c = scene.positions[t.corners.z];
    return glm::cross(b - a, c - a);
}

std::vector<double> areas_up_to(const Scene& scene, const Shape& shape) {
    std::vector<double> up_to;
    double sum = 0;
    for (std::size_t i = 0; i < shape.triangle_count; ++i)
        up_to.push_back(sum += glm::length(area_vector(scene, scene.triangles[shape.first_triangle + i])));
    return up_to;
}

}  // namespace

SensorPlaces::SensorPlaces(const Scene& scene) : scene_(scene) {
    for (const SensorPoint& point : scene.sensor_points)
        if (point.shape >= 0 && area_up_to_.count(point.shape) == 0)
            area_up_to_[point.shape] = areas_up_to(scene, scene.shapes[static_cast<std::size_t>(point.shape)]);
}

SensorPlace SensorPlaces::at(std::size_t i, const glm::dvec2& u) const {
    const SensorPoint& point = scene_.sensor_points[i];
    return is_shape(i) ? on_shape(point.shape, u) : SensorPlace{point.position, point.normal};
}

/// u.x chooses the triangle, by area, and what is left of it the place in the triangle.
SensorPlace SensorPlaces::on_shape(std::int64_t shape, const glm::dvec2& u) const {
    const std::vector<double>& up_to = area_up_to_.at(shape);
    const double area = u.x * up_to.back();
    const auto found = std::upper_bound(up_to.begin(), up_to.end(), area);
    const auto which = std::min(static_cast<std::size_t>(found - up_to.begin()), up_to.size() - 1);
    const double before = which > 0 ? up_to[which - 1] : 0.0, own = up_to[which] - before;
    const Triangle3& t = scene_.triangles[scene_.shapes[static_cast<std::size_t>(shape)].first_triangle + which];
    const double root = own > 0 ? std::sqrt(std::clamp((area - before) / own, 0.0, 1.0)) : 0.0, v = u.y;
    const glm::dvec3 position = (1 - root) * scene_.positions[t.corners.x] + root * (1 - v) * scene_.positions[t.corners.y] +
                                root * v * scene_.positions[t.corners.z];
    return {position, glm::normalize(area_vector(scene_, t))};
}

glm::dvec3 middle_of_sensors(const Scene& scene) {
    const SensorPlaces places(scene);
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < places.size(); ++i) sum += places.at(i, glm::dvec2(0.5)).position;
    return sum / static_cast<double>(std::max<std::size_t>(places.size(), 1));
}

}  // namespace pencil
