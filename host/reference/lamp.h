// What a point light sends into a direction.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace pencil {

/// Factor of the intensity on the axis. `direction`: from the light, unit, in its own frame.
double lamp_factor(const PointLight& light, const std::vector<LightProfile>& profiles, const glm::dvec3& direction);

/// Integral of the factor over all directions [sr], roughly: it is for the choice between lights.
double lamp_extent(const PointLight& light, const std::vector<LightProfile>& profiles);

}  // namespace pencil
