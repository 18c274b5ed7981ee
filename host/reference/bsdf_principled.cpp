// Disney's principled BSDF as Mitsuba 3 has it (Burley 2012 and 2015): a diffuse base with retro-reflection, sheen and flattened subsurface
// scattering; one rough boundary that reflects as a dielectric, a tinted one or a metal, and lets spec_trans through; a clearcoat. Functions
// and units: reference/bsdf.h.
#include <algorithm>

#include "reference/bsdf.h"
#include "reference/fresnel.h"
#include "reference/microfacets.h"

namespace pencil {
namespace {

float luminance(const glm::vec3& c) { return 0.212671F * c.x + 0.715160F * c.y + 0.072169F * c.z; }

glm::vec3 tint_of(const glm::vec3& c) {
    const float l = luminance(c);
    return l > 0.0F ? c / l : glm::vec3(1.0F);
}

float schlick_weight(float cosine) {
    const float x = std::clamp(1.0F - cosine, 0.0F, 1.0F), x2 = x * x;
    return x2 * x2 * x;
}

/// Schlick's approximation; by the angle in the thinner medium.
glm::vec3 schlick(const glm::vec3& r0, float cosine, float eta) {
    const float w = schlick_weight(eta > 1.0F ? cosine : fresnel_dielectric(cosine, eta).cos_refracted);
    return r0 + w * (1.0F - r0);
}

/// Anisotropy stretches roughness^2 (Burley 2012, 5.4).
Microfacets boundary(const SurfaceMaterial& material) {
    const float r2 = material.alpha.x * material.alpha.x, aspect = std::sqrt(1.0F - 0.9F * material.principled.anisotropic);
    return {glm::max(glm::vec2(r2 / aspect, r2 * aspect), glm::vec2(0.001F)), false};
}

/// Normals of the clearcoat: Burley's GTR1 (2012, appendix B).
struct Clearcoat {
    float alpha2;
    explicit Clearcoat(float gloss) : alpha2(0.1F + gloss * (0.001F - 0.1F)) { alpha2 *= alpha2; }

    float density(float cosine) const {
        return (alpha2 - 1.0F) * inverse_pi / (std::log(alpha2) * (1.0F + (alpha2 - 1.0F) * cosine * cosine));
    }
    glm::vec3 sample(const glm::dvec2& u) const {
        const double cos2 = (1 - std::pow(static_cast<double>(alpha2), 1 - u.y)) / (1 - static_cast<double>(alpha2));
        const double sine = std::sqrt(std::max(1 - cos2, 0.0)), phi = 2 * 3.14159265358979323846 * u.x;
        return glm::vec3(sine * std::cos(phi), sine * std::sin(phi), std::sqrt(std::max(cos2, 0.0)));
    }
};

/// How the parts weigh.
struct Weights {
    float base, transmitting;  // of the diffuse base, and of what has a second side
    float sample_clearcoat, sample_base;
    explicit Weights(const SurfaceMaterial& material) {
        const PrincipledParameters& p = material.principled;
        base = (1.0F - p.metallic) * (1.0F - p.spec_trans);
        transmitting = (1.0F - p.metallic) * p.spec_trans;
        // From inside there is the boundary alone. Outside, it weighs 1 as against these.
        sample_clearcoat = material.from_inside ? 0.0F : 0.25F * p.clearcoat;
        sample_base = material.from_inside ? 0.0F : base;
    }
    float sum() const { return 1.0F + sample_clearcoat + sample_base; }
    /// Probability that what meets a facet with dielectric reflectance `f` is sent back.
    float reflects(const SurfaceMaterial& material, float f) const { return material.from_inside ? f : 1.0F - transmitting * (1.0F - f); }
};

struct Facet {
    glm::vec3 m;
    float cos_o, cos_i;
    bool reflects, possible;
    Facet(const glm::vec3& omega_o, const glm::vec3& omega_i, float eta) : reflects(omega_i.z > 0.0F) {
        m = glm::normalize(omega_o + omega_i * (reflects ? 1.0F : eta));
        if (m.z < 0.0F) m = -m;
        cos_o = glm::dot(omega_o, m);
        cos_i = glm::dot(omega_i, m);
        possible = cos_o > 0.0F && (reflects ? cos_i > 0.0F : cos_i < 0.0F);
    }
    float jacobian(float eta) const {
        const float s = cos_o + eta * cos_i;
        return reflects ? 0.25F / cos_i : eta * eta * -cos_i / (s * s);
    }
};

glm::vec3 boundary_fresnel(const SurfaceMaterial& material, float dielectric, float cosine) {
    const PrincipledParameters& p = material.principled;
    const float eta = material.eta.x;
    if (material.from_inside) return glm::vec3(Weights(material).transmitting * dielectric);
    glm::vec3 sum((1.0F - p.metallic) * (1.0F - p.spec_tint) * dielectric);
    if (p.metallic > 0.0F) sum += p.metallic * schlick(material.albedo, cosine, eta);
    if (p.spec_tint > 0.0F) {
        const float r = (eta - 1.0F) / (eta + 1.0F);
        sum += (1.0F - p.metallic) * p.spec_tint * schlick(tint_of(material.albedo) * (r * r), cosine, eta);
    }
    return sum;
}

glm::vec3 evaluate_boundary(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i, const Facet& facet) {
    if (!facet.possible) return glm::vec3(0.0F);
    const Microfacets facets = boundary(material);
    const float eta = material.eta.x, f = fresnel_dielectric(facet.cos_o, eta).reflected;
    const float common = facets.density(facet.m) * facets.visible(omega_o, facet.m) * facets.visible(omega_i, facet.m) / omega_o.z;
    if (facet.reflects) return boundary_fresnel(material, f, facet.cos_o) * (0.25F * common);
    const float through = Weights(material).transmitting * (1.0F - f) * facet.cos_o * facet.jacobian(eta) / (eta * eta);
    return glm::sqrt(material.albedo) * (through * common);
}

/// G1 of GGX with roughness 1/4, whatever the clearcoat's.
float clearcoat_masking(float cosine) { return 2.0F / (1.0F + std::sqrt(1.0F + 0.0625F * (1.0F / (cosine * cosine) - 1.0F))); }

float evaluate_clearcoat(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i, const Facet& facet) {
    const PrincipledParameters& p = material.principled;
    if (!(p.clearcoat > 0.0F && facet.possible)) return 0.0F;
    const float f = schlick(glm::vec3(0.04F), facet.cos_o, material.eta.x).x, d = Clearcoat(p.clearcoat_gloss).density(facet.m.z);
    return 0.25F * p.clearcoat * f * d * clearcoat_masking(omega_o.z) * clearcoat_masking(omega_i.z) * omega_i.z;
}

glm::vec3 evaluate_base(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i, const Facet& facet) {
    const PrincipledParameters& p = material.principled;
    const float weight = Weights(material).base;
    if (!(weight > 0.0F)) return glm::vec3(0.0F);
    const float fo = schlick_weight(omega_o.z), fi = schlick_weight(omega_i.z), r = 2.0F * material.alpha.x * facet.cos_i * facet.cos_i;
    float f = (1.0F - 0.5F * fo) * (1.0F - 0.5F * fi) + r * (fo + fi + fo * fi * (r - 1.0F));
    if (p.flatness > 0.0F) {
        const float ss = (1.0F + fo * (0.5F * r - 1.0F)) * (1.0F + fi * (0.5F * r - 1.0F));
        f += p.flatness * (1.25F * (ss * (1.0F / (omega_o.z + omega_i.z) - 0.5F) + 0.5F) - f);
    }
    glm::vec3 sum = material.albedo * (weight * inverse_pi * f);
    if (p.sheen > 0.0F) {
        const glm::vec3 colour = glm::vec3(1.0F) + p.sheen_tint * (tint_of(material.albedo) - 1.0F);
        sum += colour * (p.sheen * (1.0F - p.metallic) * schlick_weight(std::abs(facet.cos_i)));
    }
    return sum * omega_i.z;
}

}  // namespace

glm::vec3 evaluate_principled(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!(omega_o.z > 0.0F) || omega_i.z == 0.0F || (omega_i.z < 0.0F && !material.transmits())) return glm::vec3(0.0F);
    const Facet facet(omega_o, omega_i, material.eta.x);
    glm::vec3 sum = evaluate_boundary(material, omega_o, omega_i, facet);
    if (material.from_inside || !facet.reflects) return sum;
    return sum + evaluate_clearcoat(material, omega_o, omega_i, facet) + evaluate_base(material, omega_o, omega_i, facet);
}

glm::vec3 albedo_principled(const SurfaceMaterial& material, const glm::vec3&) { return material.albedo; }

BsdfSample sample_principled(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u, double lobe) {
    if (!(omega_o.z > 0.0F)) return {};
    const Weights weights(material);
    const float eta = material.eta.x;
    double left = lobe * weights.sum();
    BsdfSample sample;
    if (left < static_cast<double>(weights.sample_base)) {
        sample.omega_i = cosine_direction(u);
    } else if ((left -= weights.sample_base) < static_cast<double>(weights.sample_clearcoat)) {
        sample.omega_i = reflect_about(omega_o, Clearcoat(material.principled.clearcoat_gloss).sample(u));
        if (!(sample.omega_i.z > 0.0F)) return {};
    } else {
        left -= weights.sample_clearcoat;
        const glm::vec3 m = boundary(material).sample(omega_o, u);
        const Fresnel f = fresnel_dielectric(glm::dot(omega_o, m), eta);
        const bool reflects = left < static_cast<double>(weights.reflects(material, f.reflected));
        sample.omega_i = reflects ? reflect_about(omega_o, m) : refract_about(omega_o, m, f.cos_refracted, eta);
        if ((sample.omega_i.z > 0.0F) != reflects) return {};
        if (!reflects) sample.eta = eta;
    }
    sample.pdf = pdf_principled(material, omega_o, sample.omega_i);
    if (!(sample.pdf > 0.0F)) return {};
    sample.weight = evaluate_principled(material, omega_o, sample.omega_i) / sample.pdf;
    return sample;
}

float pdf_principled(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    if (!(omega_o.z > 0.0F) || omega_i.z == 0.0F || (omega_i.z < 0.0F && !material.transmits())) return 0.0F;
    const Weights weights(material);
    const Facet facet(omega_o, omega_i, material.eta.x);
    float sum = facet.reflects ? weights.sample_base * inverse_pi * omega_i.z : 0.0F;
    if (facet.possible) {
        const float share = weights.reflects(material, fresnel_dielectric(facet.cos_o, material.eta.x).reflected);
        sum += (facet.reflects ? share : 1.0F - share) * boundary(material).pdf(omega_o, facet.m) * facet.jacobian(material.eta.x);
        if (facet.reflects && weights.sample_clearcoat > 0.0F)
            sum += weights.sample_clearcoat * Clearcoat(material.principled.clearcoat_gloss).density(facet.m.z) * facet.m.z *
                   facet.jacobian(1.0F);
    }
    return sum / weights.sum();
}

}  // namespace pencil
