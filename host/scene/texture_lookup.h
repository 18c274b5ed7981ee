// Values of textures.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace pencil {

/// Colour and opacity at texture coordinates. `colour`: of the vertices, interpolated.
glm::vec4 look_up(const Texture& texture, const glm::vec2& uv, const glm::vec3& colour);

/// Change of the luminance by u and by v, of a bitmap as it is interpolated; 0 for others.
glm::vec2 look_up_slope(const Texture& texture, const glm::vec2& uv);

/// Of all texels alike.
glm::vec3 mean_colour(const Texture& texture);

/// Radiance of an emitting shape, of all points of its texture alike [W m^-2 sr^-1].
glm::dvec3 mean_radiance(const Scene& scene, const Shape& shape);

}  // namespace pencil
