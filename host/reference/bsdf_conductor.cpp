// A metal: a smooth mirror, or microfacets of one (Mitsuba's conductor and roughconductor; Walter et al. 2007, eq. 20). Functions and
// units: reference/bsdf.h.
#include "reference/bsdf.h"
#include "reference/fresnel.h"
#include "reference/microfacets.h"

namespace pencil {
namespace {

glm::vec3 reflected(const SurfaceMaterial& material, float cosine) {
    if (material.perfect_mirror) return material.specular;
    glm::vec3 f;
    for (int c = 0; c < 3; ++c) f[c] = fresnel_conductor(cosine, material.eta[c], material.k[c]);
    return f * material.specular;
}

}  // namespace

glm::vec3 evaluate_conductor(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (material.smooth() || !(omega_o.z > 0.0F && omega_i.z > 0.0F)) return glm::vec3(0.0F);
    const Microfacets facets(material.alpha, material.beckmann);
    const glm::vec3 m = glm::normalize(omega_o + omega_i);
    const float geometry = facets.visible(omega_o, m) * facets.visible(omega_i, m);
    return reflected(material, glm::dot(omega_o, m)) * (facets.density(m) * geometry / (4.0F * omega_o.z));
}

glm::vec3 albedo_conductor(const SurfaceMaterial& material, const glm::vec3& omega_o) { return reflected(material, omega_o.z); }

BsdfSample sample_conductor(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u, double) {
    if (!(omega_o.z > 0.0F)) return {};
    if (material.smooth()) return {{-omega_o.x, -omega_o.y, omega_o.z}, reflected(material, omega_o.z), 1.0F, true};
    const Microfacets facets(material.alpha, material.beckmann);
    const glm::vec3 m = facets.sample(omega_o, u), omega_i = reflect_about(omega_o, m);
    if (!(omega_i.z > 0.0F)) return {};
    const float cosine = glm::dot(omega_o, m);
    return {omega_i, reflected(material, cosine) * facets.visible(omega_i, m), facets.pdf(omega_o, m) / (4.0F * cosine)};
}

float pdf_conductor(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (material.smooth() || !(omega_o.z > 0.0F && omega_i.z > 0.0F)) return 0.0F;
    const glm::vec3 m = glm::normalize(omega_o + omega_i);
    return Microfacets(material.alpha, material.beckmann).pdf(omega_o, m) / (4.0F * glm::dot(omega_o, m));
}

}  // namespace pencil
