// Glass: a smooth boundary, microfacets of one, or a thin pane (Mitsuba's dielectric, roughdielectric and thindielectric; Walter et al. 2007,
// eqs. 20 and 21). What is refracted is radiance: it changes by the square of the index (Veach 1997, 5.2). Functions and units:
// reference/bsdf.h.
#include "reference/bsdf.h"
#include "reference/fresnel.h"
#include "reference/microfacets.h"

namespace pencil {
namespace {

bool has_facets(const SurfaceMaterial& material) { return !only_delta(material); }

/// Reflected by two parallel boundaries, with all that goes to and fro between them: R + T^2 R / (1 - R^2), T = 1 - R.
float reflected_by_pane(float cosine, float eta) {
    const float r = fresnel_dielectric(cosine, eta).reflected;
    return 2.0F * r / (1.0F + r);
}

/// What two directions have to do with each other by one facet.
struct Meeting {
    glm::vec3 m;
    float cos_o, cos_i;  // to the facet
    bool reflects, possible;
    float jacobian;  // solid angle of facets over that of omega_i

    Meeting(const glm::vec3& omega_o, const glm::vec3& omega_i, float eta) : reflects(omega_i.z > 0.0F) {
        m = glm::normalize(omega_o + omega_i * (reflects ? 1.0F : eta));
        if (m.z < 0.0F) m = -m;
        cos_o = glm::dot(omega_o, m);
        cos_i = glm::dot(omega_i, m);
        possible = omega_o.z > 0.0F && omega_i.z != 0.0F && cos_o > 0.0F && cos_i * omega_i.z > 0.0F;
        const float sum = cos_o + eta * cos_i;
        jacobian = reflects ? 0.25F / cos_o : eta * eta * -cos_i / (sum * sum);
    }
};

BsdfSample sample_smooth(const SurfaceMaterial& material, const glm::vec3& omega_o, double lobe) {
    const float eta = material.eta.x;
    const Fresnel f = fresnel_dielectric(omega_o.z, eta);
    const float r = material.thin ? reflected_by_pane(omega_o.z, eta) : f.reflected;
    if (lobe < static_cast<double>(r)) return {{-omega_o.x, -omega_o.y, omega_o.z}, material.specular, r, true};
    if (material.thin) return {-omega_o, material.transmitted, 1.0F - r, true, true};
    const glm::vec3 omega_i = refract_about(omega_o, {0, 0, 1}, f.cos_refracted, eta);
    return {omega_i, material.transmitted / (eta * eta), 1.0F - r, true, false, eta};
}

}  // namespace

glm::vec3 evaluate_dielectric(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!has_facets(material)) return glm::vec3(0.0F);
    const float eta = material.eta.x;
    const Meeting meeting(omega_o, omega_i, eta);
    if (!meeting.possible) return glm::vec3(0.0F);
    const Microfacets facets(material.alpha, material.beckmann);
    const float f = fresnel_dielectric(meeting.cos_o, eta).reflected;
    const float common = facets.density(meeting.m) * facets.visible(omega_o, meeting.m) * facets.visible(omega_i, meeting.m) *
                         meeting.cos_o * meeting.jacobian / omega_o.z;
    return meeting.reflects ? material.specular * (f * common) : material.transmitted * ((1.0F - f) * common / (eta * eta));
}

glm::vec3 albedo_dielectric(const SurfaceMaterial& material, const glm::vec3& omega_o) {
    const float r = material.thin ? reflected_by_pane(omega_o.z, material.eta.x) : fresnel_dielectric(omega_o.z, material.eta.x).reflected;
    return r * material.specular + (1.0F - r) * material.transmitted;
}

BsdfSample sample_dielectric(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u, double lobe) {
    if (!(omega_o.z > 0.0F)) return {};
    if (!has_facets(material)) return sample_smooth(material, omega_o, lobe);
    const float eta = material.eta.x;
    const Microfacets facets(material.alpha, material.beckmann);
    const glm::vec3 m = facets.sample(omega_o, u);
    const Fresnel f = fresnel_dielectric(glm::dot(omega_o, m), eta);
    const bool reflects = lobe < static_cast<double>(f.reflected);
    const glm::vec3 omega_i = reflects ? reflect_about(omega_o, m) : refract_about(omega_o, m, f.cos_refracted, eta);
    if (!(reflects ? omega_i.z > 0.0F : omega_i.z < 0.0F)) return {};
    const float density = pdf_dielectric(material, omega_o, omega_i), seen = facets.visible(omega_i, m);
    if (reflects) return {omega_i, material.specular * seen, density};
    return {omega_i, material.transmitted * (seen / (eta * eta)), density, false, false, eta};
}

float pdf_dielectric(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!has_facets(material)) return 0.0F;
    const Meeting meeting(omega_o, omega_i, material.eta.x);
    if (!meeting.possible) return 0.0F;
    const float f = fresnel_dielectric(meeting.cos_o, material.eta.x).reflected;
    return (meeting.reflects ? f : 1.0F - f) * Microfacets(material.alpha, material.beckmann).pdf(omega_o, meeting.m) * meeting.jacobian;
}

glm::vec3 straight_transmittance(const SurfaceMaterial& material, const glm::vec3& omega_o) {
    if (material.absorbs) return glm::vec3(0.0F);
    if (material.model == MATERIAL_PASS) return glm::vec3(1.0F);
    if (material.model != MATERIAL_DIELECTRIC || !material.thin) return glm::vec3(0.0F);
    return (1.0F - reflected_by_pane(omega_o.z, material.eta.x)) * material.transmitted;
}

}  // namespace pencil
