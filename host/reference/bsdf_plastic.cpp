// A diffuse base under a dielectric varnish, smooth or rough (Mitsuba's plastic and roughplastic): light that gets in is scattered to and fro
// between base and varnish until it gets out, f = albedo / (1 - albedo R_i) T(o) T(i) / (pi eta^2). Linear plastics let the colour of the
// base act once only: R_i alone in the denominator. Functions and units: reference/bsdf.h.
#include "reference/bsdf.h"
#include "reference/fresnel.h"
#include "reference/microfacets.h"
#include "reference/plastic_table.h"

namespace pencil {
namespace {

float transmitted(const SurfaceMaterial& material, float cosine) {
    if (material.smooth()) return 1.0F - fresnel_dielectric(cosine, material.eta.x).reflected;
    return material.table->transmitted(cosine, material.alpha.x);
}

/// Of the base, with 1 / eta^2 but without the transmittances.
glm::vec3 base_albedo(const SurfaceMaterial& material) {
    const float inside = material.table->reflected_inside(material.alpha.x), eta = material.eta.x;
    const glm::vec3 kept = material.nonlinear ? material.albedo * inside : glm::vec3(inside);
    return material.albedo / ((1.0F - kept) * (eta * eta));
}

/// Probability of sampling the varnish, if it lets `t` through (Mitsuba).
float varnish_share(const SurfaceMaterial& material, float t) {
    const float s = material.specular.x + material.specular.y + material.specular.z,
                d = material.albedo.x + material.albedo.y + material.albedo.z;
    const float varnish = (1.0F - t) * s, base = t * d;
    return varnish + base > 0.0F ? varnish / (varnish + base) : 0.0F;
}

}  // namespace

glm::vec3 evaluate_plastic(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!(omega_o.z > 0.0F && omega_i.z > 0.0F)) return glm::vec3(0.0F);
    glm::vec3 sum = base_albedo(material) * (transmitted(material, omega_o.z) * transmitted(material, omega_i.z) * inverse_pi * omega_i.z);
    if (material.smooth()) return sum;
    const Microfacets facets(material.alpha, material.beckmann);
    const glm::vec3 m = glm::normalize(omega_o + omega_i);
    const float f = fresnel_dielectric(glm::dot(omega_o, m), material.eta.x).reflected;
    return sum + material.specular * (f * facets.density(m) * facets.visible(omega_o, m) * facets.visible(omega_i, m) / (4.0F * omega_o.z));
}

glm::vec3 albedo_plastic(const SurfaceMaterial& material, const glm::vec3& omega_o) {
    const float t = transmitted(material, omega_o.z), eta = material.eta.x;
    const float out = (1.0F - material.table->reflected_inside(material.alpha.x)) * eta * eta;  // mean of T(i), by reciprocity
    return (1.0F - t) * material.specular + t * std::min(out, 1.0F) * base_albedo(material);
}

BsdfSample sample_plastic(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u, double lobe) {
    if (!(omega_o.z > 0.0F)) return {};
    const float t = transmitted(material, omega_o.z), share = varnish_share(material, t);
    const bool varnish = lobe < static_cast<double>(share);
    if (varnish && material.smooth()) return {{-omega_o.x, -omega_o.y, omega_o.z}, material.specular * ((1.0F - t) / share), share, true};
    const glm::vec3 omega_i =
        varnish ? reflect_about(omega_o, Microfacets(material.alpha, material.beckmann).sample(omega_o, u)) : cosine_direction(u);
    const float density = pdf_plastic(material, omega_o, omega_i);
    if (!(density > 0.0F)) return {};
    return {omega_i, evaluate_plastic(material, omega_o, omega_i) / density, density};
}

float pdf_plastic(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!(omega_o.z > 0.0F && omega_i.z > 0.0F)) return 0.0F;
    const float share = varnish_share(material, transmitted(material, omega_o.z)), base = (1.0F - share) * inverse_pi * omega_i.z;
    if (material.smooth()) return base;
    const glm::vec3 m = glm::normalize(omega_o + omega_i);
    return base + share * Microfacets(material.alpha, material.beckmann).pdf(omega_o, m) / (4.0F * glm::dot(omega_o, m));
}

}  // namespace pencil
