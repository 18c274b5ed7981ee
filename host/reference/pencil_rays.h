// Rays of pencils: from their centres through the texels of their maps.
#pragma once

#include <glm/glm.hpp>

#include "options/pencil_field.h"
#include "reference/ray_scene.h"
#include "reference/sampler.h"

namespace pencil {

/// Through a random point of pixel (x, y) of the field's image; a ray of no length where that is of no pencil. thesis eq. (4.25), inverted.
inline Ray pencil_ray(const PencilField& field, const RayScene& scene, int x, int y, Sampler& sampler) {
    const int tile = field.tile_of(x, y);
    const glm::dvec2 inside = sampler.next_2d();
    if (tile == field.count()) return {{}, {}, 0.0F};
    const double u = 2 * (x % field.map + inside.x) / field.map - 1, v = 2 * (y % field.map + inside.y) / field.map - 1;
    const double z = 1 - std::abs(u) - std::abs(v), fold = std::max(-z, 0.0);
    const glm::dvec3 direction(u - std::copysign(fold, u), v - std::copysign(fold, v), z);
    return {glm::vec3(scene.to_scene(field.centres[static_cast<std::size_t>(tile)])), glm::vec3(glm::normalize(direction))};
}

}  // namespace pencil
