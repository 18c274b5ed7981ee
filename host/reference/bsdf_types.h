// What the models of scattering share. Directions are unit vectors of the shading frame on the side that was seen, the normal is +z: omega_o
// to the viewer, always above the horizon, omega_i to the light, below it if it comes through the surface.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace pencil {

class PlasticTable;

/// Scattering of one side of a surface at one point: textures have been looked up.
struct SurfaceMaterial {
    int model = MATERIAL_DIFFUSE;
    bool absorbs = false;      // the back of what has one side
    bool from_inside = false;  // the back of what transmits; eta is turned round
    glm::vec3 albedo{0.0F};
    glm::vec3 specular{1.0F}, transmitted{1.0F};
    glm::vec3 eta{1.5F}, k{0.0F};  // index beyond the surface over the one on this side; with k that of a conductor
    glm::vec2 alpha{0.0F};
    bool perfect_mirror = false, beckmann = false, nonlinear = false, thin = false;
    float exponent = 30.0F;
    PrincipledParameters principled{};
    const PlasticTable* table = nullptr;  // of a plastic

    bool smooth() const { return alpha.x <= 0.0F && alpha.y <= 0.0F; }
    bool transmits() const { return model == MATERIAL_DIELECTRIC || (model == MATERIAL_PRINCIPLED && principled.spec_trans > 0.0F); }
};

/// A direction that light is followed to.
struct BsdfSample {
    glm::vec3 omega_i{0.0F};
    glm::vec3 weight{0.0F};  // BSDF times |cosine| over density
    float pdf = 0;           // as of `pdf`, with `delta` the probability of the lobe; 0: there is no direction
    bool delta = false;      // there is no other direction that this could have been
    bool passes = false;     // light goes on as if there were no surface
    float eta = 1;           // index of refraction on the side it goes to over the one it came from
};

}  // namespace pencil
