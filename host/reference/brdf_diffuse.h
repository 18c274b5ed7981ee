// The diffuse BRDF, albedo / pi. Functions and units: reference/brdf.h.
#pragma once

#include "reference/brdf_types.h"

namespace pencil {

glm::vec3 evaluate_diffuse(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i);
glm::vec3 albedo_diffuse(const SurfaceMaterial& material, const glm::vec3& omega_o);
BrdfSample sample_diffuse(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::dvec2& u);
float pdf_diffuse(const SurfaceMaterial& material, const glm::vec3& omega_o, const glm::vec3& omega_i);

}  // namespace pencil
