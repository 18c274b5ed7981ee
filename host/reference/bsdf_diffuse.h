// The diffuse BRDF, albedo / pi. Functions and units: reference/bsdf.h. Inline, so that a path pays for nothing that this model does not
// need: calls cost 6 % of its time.
#pragma once

#include <cmath>

#include "reference/bsdf_types.h"

namespace pencil {

constexpr float inverse_pi = 0.318309886F;

/// By the cosine: points of the unit disk, lifted to the hemisphere (Malley's method).
inline glm::vec3 cosine_direction(const glm::dvec2& u) {
    const auto phi = static_cast<float>(2 * 3.14159265358979323846 * u.x), r2 = static_cast<float>(u.y);
    const float r = std::sqrt(r2);
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(1.0F - r2)};
}

inline glm::vec3 evaluate_diffuse(const SurfaceMaterial& material, const glm::vec3&, const glm::vec3& omega_i) {
    return omega_i.z > 0.0F ? material.albedo * (inverse_pi * omega_i.z) : glm::vec3(0.0F);
}

inline glm::vec3 albedo_diffuse(const SurfaceMaterial& material, const glm::vec3&) { return material.albedo; }

inline BsdfSample sample_diffuse(const SurfaceMaterial& material, const glm::vec3&, const glm::dvec2& u, double) {
    const glm::vec3 omega_i = cosine_direction(u);
    return {omega_i, material.albedo, omega_i.z * inverse_pi};
}

inline float pdf_diffuse(const SurfaceMaterial&, const glm::vec3&, const glm::vec3& omega_i) {
    return omega_i.z > 0.0F ? omega_i.z * inverse_pi : 0.0F;
}

}  // namespace pencil
