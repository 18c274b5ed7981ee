#include "reference/sensor_receivers.h"

namespace pencil {

namespace {

/// Beyond the rounding of coordinates, which are at most 2: many sensors lie on surfaces [scene units].
constexpr float before_surface = 2e-6F;

}  // namespace

RayHit SensorReceivers::at(std::size_t i, Sampler& sampler) const {
    const SensorPlace place = places_.at(i, sampler.next_2d());
    RayHit hit{};
    hit.point = glm::vec3(rays_.to_scene(place.position));
    hit.normal = hit.shading = glm::vec3(place.normal);
    hit.offset = before_surface;
    hit.front = true;
    return hit;
}

}  // namespace pencil
