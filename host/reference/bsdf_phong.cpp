// The modified Phong model, f = albedo / pi + specular (n + 2) / (2 pi) cos^n alpha, alpha the angle to the mirror direction (Lafortune and
// Willems 1994; Mitsuba 0.6 phong). Functions and units: reference/bsdf.h.
#include <algorithm>

#include "reference/bsdf.h"
#include "reference/shading_frame.h"

namespace pencil {
namespace {

float lobe_cosine(const glm::vec3& omega_o, const glm::vec3& omega_i) {
    return std::max(omega_o.z * omega_i.z - omega_o.x * omega_i.x - omega_o.y * omega_i.y, 0.0F);
}

/// Probability of sampling the lobe.
float lobe_share(const SurfaceMaterial& material) {
    const float s = material.specular.x + material.specular.y + material.specular.z,
                d = material.albedo.x + material.albedo.y + material.albedo.z;
    return s + d > 0.0F ? s / (s + d) : 0.0F;
}

}  // namespace

glm::vec3 evaluate_phong(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!(omega_o.z > 0.0F && omega_i.z > 0.0F)) return glm::vec3(0.0F);
    const float lobe = 0.5F * (material.exponent + 2.0F) * std::pow(lobe_cosine(omega_o, omega_i), material.exponent);
    return (material.albedo + lobe * material.specular) * (inverse_pi * omega_i.z);
}

glm::vec3 albedo_phong(const SurfaceMaterial& material, const glm::vec3&) { return material.albedo + material.specular; }

BsdfSample sample_phong(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u, double lobe) {
    if (!(omega_o.z > 0.0F)) return {};
    glm::vec3 omega_i = cosine_direction(u);
    if (lobe < static_cast<double>(lobe_share(material))) {
        const double cosine = std::pow(u.y, 1 / (material.exponent + 1.0)), sine = std::sqrt(std::max(1 - cosine * cosine, 0.0)),
                     phi = 2 * 3.14159265358979323846 * u.x;
        omega_i = ShadingFrame({-omega_o.x, -omega_o.y, omega_o.z}).to_world(glm::vec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
    }
    const float density = pdf_phong(material, omega_o, omega_i);
    if (!(density > 0.0F)) return {};
    return {omega_i, evaluate_phong(material, omega_o, omega_i) / density, density};
}

float pdf_phong(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!(omega_o.z > 0.0F && omega_i.z > 0.0F)) return 0.0F;
    const float share = lobe_share(material),
                lobe = 0.5F * (material.exponent + 1.0F) * std::pow(lobe_cosine(omega_o, omega_i), material.exponent);
    return inverse_pi * (share * lobe + (1.0F - share) * omega_i.z);
}

}  // namespace pencil
