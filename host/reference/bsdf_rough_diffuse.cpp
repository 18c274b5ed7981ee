// Oren and Nayar's rough diffuse surface (SIGGRAPH 1994, eqs. 27 to 30: single and double scattering between facets), as Mitsuba 0.6's
// roughdiffuse without its fast approximation. Functions and units: reference/bsdf.h.
#include <algorithm>

#include "reference/bsdf.h"

namespace pencil {
namespace {

float sine_of(const glm::vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

}  // namespace

glm::vec3 evaluate_rough_diffuse(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!(omega_o.z > 0.0F && omega_i.z > 0.0F)) return glm::vec3(0.0F);
    // From roughness of Beckmann's kind to the spread of slopes; Mitsuba's factor.
    const float sigma2 = 0.5F * material.alpha.x * material.alpha.x;
    const float sin_o = sine_of(omega_o), sin_i = sine_of(omega_i);
    const float cos_phi = sin_o > 1e-4F && sin_i > 1e-4F ? (omega_o.x * omega_i.x + omega_o.y * omega_i.y) / (sin_o * sin_i) : 0.0F;
    const float theta_o = std::atan2(sin_o, omega_o.z), theta_i = std::atan2(sin_i, omega_i.z);
    const float alpha = std::max(theta_o, theta_i), beta = std::min(theta_o, theta_i);
    const float b3 = 2.0F * beta * inverse_pi, ab = 4.0F * inverse_pi * inverse_pi * alpha * beta;

    const float spread = sigma2 / (sigma2 + 0.09F);
    const float c1 = 1.0F - 0.5F * sigma2 / (sigma2 + 0.33F);
    const float c2 = 0.45F * spread * (std::sin(alpha) - (cos_phi > 0.0F ? 0.0F : b3 * b3 * b3));
    const float c3 = 0.125F * spread * ab * ab;
    const float c4 = 0.17F * sigma2 / (sigma2 + 0.13F);
    const float once = c1 + cos_phi * c2 * std::tan(beta) + (1.0F - std::abs(cos_phi)) * c3 * std::tan(0.5F * (alpha + beta));
    const float twice = c4 * (1.0F - cos_phi * b3 * b3);
    return (once + twice * material.albedo) * material.albedo * (inverse_pi * omega_i.z);
}

glm::vec3 albedo_rough_diffuse(const SurfaceMaterial& material, const glm::vec3&) { return material.albedo; }

BsdfSample sample_rough_diffuse(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u, double) {
    const glm::vec3 omega_i = cosine_direction(u);
    if (!(omega_o.z > 0.0F && omega_i.z > 0.0F)) return {};
    const float density = omega_i.z * inverse_pi;
    return {omega_i, evaluate_rough_diffuse(material, omega_o, omega_i) / density, density};
}

float pdf_rough_diffuse(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    return omega_o.z > 0.0F ? pdf_diffuse(material, omega_o, omega_i) : 0.0F;
}

}  // namespace pencil
