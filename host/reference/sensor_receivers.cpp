#include "reference/sensor_receivers.h"

namespace pencil {

RayHit SensorReceivers::at(std::size_t i, Sampler& sampler) const {
    const SensorPlace place = places_.at(i, sampler.next_2d());
    RayHit hit{};
    hit.point = glm::vec3(rays_.to_scene(place.position));
    hit.normal = hit.shading = glm::vec3(place.normal);
    hit.offset = static_cast<float>(before_surface);
    hit.front = true;
    return hit;
}

}  // namespace pencil
