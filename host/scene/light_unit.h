// The unit in which light is counted while an image is made. Radiance is linear in the emitters: divided by a power of two, all results stay
// the same but for that factor, bit by bit, and neither a sun of 1e30 nor a glow of 1e-30 leaves the range of float on its way.
#pragma once

#include "scene/scene.h"

namespace pencil {

/// The power of two that brings the strongest emitter of the scene between 1 and 2 if its light is divided by it: radiance of surfaces and of
/// the environment, irradiance of parallel light, intensity of point lights at the distance of the scene's extent. 1 without light.
double light_unit(const Scene& scene);

/// Light of the scene file in that unit.
inline glm::vec3 in_light_unit(const glm::dvec3& light, double unit) { return glm::vec3(light / unit); }

}  // namespace pencil
