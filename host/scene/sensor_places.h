// Where the sensors of Scene::sensor_points lie, those that are shapes anywhere on them.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <vector>

#include "scene/scene.h"

namespace pencil {

/// Sensors are moved so far from their places, beyond the rounding of coordinates, which are at most 2: many lie on surfaces [scene units].
constexpr double before_surface = 2e-6;

struct SensorPlace {
    glm::dvec3 position, normal;  // [world units], unit
};

class SensorPlaces {
public:
    /// `scene` must outlive this.
    explicit SensorPlaces(const Scene& scene);

    std::size_t size() const { return scene_.sensor_points.size(); }
    /// Of sensor i; on a shape evenly where u is even in [0, 1)^2, and apart where u is apart.
    SensorPlace at(std::size_t i, const glm::dvec2& u) const;
    bool is_shape(std::size_t i) const { return scene_.sensor_points[i].shape >= 0; }

private:
    SensorPlace on_shape(std::int64_t shape, const glm::dvec2& u) const;

    const Scene& scene_;
    std::map<std::int64_t, std::vector<double>> area_up_to_;  // of shapes that are measured, by triangle
};

/// The middle of all sensors, about: where coordinates are to be exact.
glm::dvec3 middle_of_sensors(const Scene& scene);

}  // namespace pencil
