// Scattering by a surface, whatever its model. Directions: reference/bsdf_types.h. `evaluate` has the cosine: it is f_s |cos theta_i|
// [1/sr], of radiance, so what is refracted into a denser medium grows by the square of the index. Densities are per solid angle [1/sr].
// Delta lobes are found by `sample` only; `evaluate` and `pdf` are those of the rest. A model enters the list of shared/material.h and has a
// file bsdf_<model>.cpp.
#pragma once

#include "reference/bsdf_diffuse.h"

namespace pencil {

// The functions of bsdf_<model>.cpp, for every model of shared/material.h beside the diffuse one.
#define BSDF_DECLARE(NAME, name)                                                                                  \
    glm::vec3 evaluate_##name(const SurfaceMaterial&, const glm::vec3& omega_o, const glm::vec3& omega_i);        \
    glm::vec3 albedo_##name(const SurfaceMaterial&, const glm::vec3& omega_o);                                    \
    BsdfSample sample_##name(const SurfaceMaterial&, const glm::vec3& omega_o, const glm::dvec2& u, double lobe); \
    float pdf_##name(const SurfaceMaterial&, const glm::vec3& omega_o, const glm::vec3& omega_i);
MATERIAL_MODELS(BSDF_DECLARE)
#undef BSDF_DECLARE

#define BSDF_EVALUATE(NAME, name) \
    case MATERIAL_##NAME:         \
        return evaluate_##name(material, omega_o, omega_i);
#define BSDF_ALBEDO(NAME, name) \
    case MATERIAL_##NAME:       \
        return albedo_##name(material, omega_o);
#define BSDF_SAMPLE(NAME, name) \
    case MATERIAL_##NAME:       \
        return sample_##name(material, omega_o, u, lobe);
#define BSDF_PDF(NAME, name) \
    case MATERIAL_##NAME:    \
        return pdf_##name(material, omega_o, omega_i);

/// f_s(omega_o, omega_i) |cos theta_i| [1/sr].
inline glm::vec3 evaluate(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    switch (material.model) {
        MATERIAL_MODELS(BSDF_EVALUATE)
        case MATERIAL_PASS:
            return glm::vec3(0.0F);
        default:
            return evaluate_diffuse(material, omega_o, omega_i);
    }
}

/// Roughly the share of the light from all around that leaves towards omega_o; a layer of the image, no part of light transport.
inline glm::vec3 albedo(const SurfaceMaterial& material, const glm::vec3& omega_o) {
    switch (material.model) {
        MATERIAL_MODELS(BSDF_ALBEDO)
        case MATERIAL_PASS:
            return glm::vec3(0.0F);
        default:
            return albedo_diffuse(material, omega_o);
    }
}

/// omega_i for `u`, uniform in [0, 1)^2, and `lobe`, uniform in [0, 1).
inline BsdfSample sample(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u, double lobe) {
    switch (material.model) {
        MATERIAL_MODELS(BSDF_SAMPLE)
        case MATERIAL_PASS:
            return {-omega_o, glm::vec3(1.0F), 1.0F, true, true};
        default:
            return sample_diffuse(material, omega_o, u, lobe);
    }
}

/// Density with which `sample` chooses omega_i [1/sr].
inline float pdf(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    switch (material.model) {
        MATERIAL_MODELS(BSDF_PDF)
        case MATERIAL_PASS:
            return 0.0F;
        default:
            return pdf_diffuse(material, omega_o, omega_i);
    }
}

#undef BSDF_EVALUATE
#undef BSDF_ALBEDO
#undef BSDF_SAMPLE
#undef BSDF_PDF

/// Whether all that the surface does is delta lobes, which light sampling cannot meet.
inline bool only_delta(const SurfaceMaterial& material) {
    switch (material.model) {
        case MATERIAL_PASS:
            return true;
        case MATERIAL_CONDUCTOR:
            return material.smooth();
        case MATERIAL_DIELECTRIC:
            return material.smooth() || material.thin || material.eta.x == 1.0F;
        default:
            return false;
    }
}

/// Share of light that goes on unturned, by a surface that passes it. Zero for others.
glm::vec3 straight_transmittance(const SurfaceMaterial& material, const glm::vec3& omega_o);

}  // namespace pencil
