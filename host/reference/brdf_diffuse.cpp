#include "reference/brdf_diffuse.h"

#include <cmath>

namespace pencil {

glm::vec3 evaluate_diffuse(const SurfaceMaterial& material, const glm::vec3&, const glm::vec3&) { return material.albedo; }

glm::vec3 albedo_diffuse(const SurfaceMaterial& material, const glm::vec3&) { return material.albedo; }

/// By the cosine: points of the unit disk, lifted to the hemisphere (Malley's method).
BrdfSample sample_diffuse(const SurfaceMaterial& material, const glm::vec3&, const glm::dvec2& u) {
    const auto phi = static_cast<float>(2 * 3.14159265358979323846 * u.x), r2 = static_cast<float>(u.y);
    const float r = std::sqrt(r2), cosine = std::sqrt(1.0F - r2);
    return {{r * std::cos(phi), r * std::sin(phi), cosine}, material.albedo, cosine};
}

float pdf_diffuse(const SurfaceMaterial&, const glm::vec3&, const glm::vec3& omega_i) { return omega_i.z; }

}  // namespace pencil
