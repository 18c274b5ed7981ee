// What the models of reflection share.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace pencil {

/// Reflection of a triangle.
struct SurfaceMaterial {
    int model = MATERIAL_DIFFUSE;
    glm::vec3 albedo{0.0F};
    bool two_sided = false;
    glm::vec3 parameters{0.0F};
};

/// A direction that light is followed to.
struct BrdfSample {
    glm::vec3 omega_i{0.0F};
    glm::vec3 weight{0.0F};  // BRDF times cosine over density
    float pdf = 0;           // as of `pdf`; 0: there is no direction
};

}  // namespace pencil
