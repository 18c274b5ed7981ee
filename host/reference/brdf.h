// Reflection of one side of a surface, whatever its model. Directions are unit vectors of the shading frame, the normal is +z: omega_o to
// the viewer, omega_i to the light. Solid angles count in units of pi steradians, so that a diffuse BRDF is its albedo and its density the
// cosine: no rounding of pi enters. A model enters the list of shared/material.h and has a file brdf_<model>.
#pragma once

#include <cmath>

#include "reference/brdf_diffuse.h"

namespace pencil {

// The functions of brdf_<model>.cpp, for every model of shared/material.h beside the diffuse one.
#define BRDF_DECLARE(NAME, name)                                                                           \
    glm::vec3 evaluate_##name(const SurfaceMaterial&, const glm::vec3& omega_o, const glm::vec3& omega_i); \
    glm::vec3 albedo_##name(const SurfaceMaterial&, const glm::vec3& omega_o);                             \
    BrdfSample sample_##name(const SurfaceMaterial&, const glm::vec3& omega_o, const glm::dvec2& u);       \
    float pdf_##name(const SurfaceMaterial&, const glm::vec3& omega_o, const glm::vec3& omega_i);
MATERIAL_MODELS(BRDF_DECLARE)
#undef BRDF_DECLARE

#define BRDF_EVALUATE(NAME, name) \
    if (material.model == MATERIAL_##NAME) return evaluate_##name(material, omega_o, omega_i);
#define BRDF_ALBEDO(NAME, name) \
    if (material.model == MATERIAL_##NAME) return albedo_##name(material, omega_o);
#define BRDF_SAMPLE(NAME, name) \
    if (material.model == MATERIAL_##NAME) return sample_##name(material, omega_o, u);
#define BRDF_PDF(NAME, name) \
    if (material.model == MATERIAL_##NAME) return pdf_##name(material, omega_o, omega_i);

/// f_r(omega_o, omega_i), without the cosine [1 / (pi sr)].
inline glm::vec3 evaluate(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    MATERIAL_MODELS(BRDF_EVALUATE)
    return evaluate_diffuse(material, omega_o, omega_i);
}

/// Share of the light from all around that leaves towards omega_o.
inline glm::vec3 albedo(const SurfaceMaterial& material, const glm::vec3& omega_o) {
    MATERIAL_MODELS(BRDF_ALBEDO)
    return albedo_diffuse(material, omega_o);
}

/// omega_i for `u`, uniform in [0, 1)^2.
inline BrdfSample sample(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u) {
    MATERIAL_MODELS(BRDF_SAMPLE)
    return sample_diffuse(material, omega_o, u);
}

/// Density with which `sample` chooses omega_i [1 / (pi sr)].
inline float pdf(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i) {
    MATERIAL_MODELS(BRDF_PDF)
    return pdf_diffuse(material, omega_o, omega_i);
}

#undef BRDF_EVALUATE
#undef BRDF_ALBEDO
#undef BRDF_SAMPLE
#undef BRDF_PDF

/// Right-handed orthonormal frame about a unit normal (Duff et al. 2017).
class ShadingFrame {
public:
    explicit ShadingFrame(const glm::vec3& n) : normal_(n) {
        const float sign = std::copysign(1.0F, n.z), a = -1.0F / (sign + n.z), b = n.x * n.y * a;
        tangent_ = glm::vec3(1.0F + sign * n.x * n.x * a, sign * b, -sign * n.x);
        bitangent_ = glm::vec3(b, sign + n.y * n.y * a, -n.y);
    }

    glm::vec3 to_world(const glm::vec3& v) const { return v.x * tangent_ + v.y * bitangent_ + v.z * normal_; }
    glm::vec3 to_local(const glm::vec3& v) const { return {glm::dot(tangent_, v), glm::dot(bitangent_, v), glm::dot(normal_, v)}; }

private:
    glm::vec3 tangent_, bitangent_, normal_;
};

}  // namespace pencil
