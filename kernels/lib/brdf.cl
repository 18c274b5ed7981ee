// Reflection by the model of a material: every kernel that reflects light asks here, no other file calls a model. Directions are unit vectors in the local frame of the side that was seen, z along
// the shading normal; omega_o, towards where the light goes, comes first, omega_i, towards where it comes from, second. A model has
//   evaluate(m, omega_o, omega_i)   f [1/sr], reciprocal; 0 where a direction is not above the horizon
//   albedo(m, omega_o)              integral of f(omega_o, omega) cos d omega over the hemisphere, at most 1
//   sample(m, omega_o, u)           omega_i for u in [0, 1)^2
//   pdf(m, omega_o, omega_i)        density of sample per solid angle [1/sr]
// A model enters the list MATERIAL_MODELS of shared/material.h; its file is found by its name. Kernels of scenes without it are the same to the
// last instruction: PENCIL_MODEL_<NAME> is 0 for them (device/features.cpp). docs/adding_a_material.md is the way through all files.

#include "lib/brdf_*.cl"
#include "lib/packet.cl"
#include "shared/material.h"

#define BRDF_IS(NAME) (PENCIL_MODEL_##NAME && m->model == MATERIAL_##NAME)
#define BRDF_EVALUATE(NAME, name) \
    if (BRDF_IS(NAME)) return name##_evaluate(m, omega_o, omega_i);
#define BRDF_ALBEDO(NAME, name) \
    if (BRDF_IS(NAME)) return name##_albedo(m, omega_o);
#define BRDF_SAMPLE(NAME, name) \
    if (BRDF_IS(NAME)) return name##_sample(m, omega_o, u);
#define BRDF_PDF(NAME, name) \
    if (BRDF_IS(NAME)) return name##_pdf(m, omega_o, omega_i);

static inline float3 brdf_evaluate(global const Material *m, float3 omega_o, float3 omega_i) {
    MATERIAL_MODELS(BRDF_EVALUATE)
    return diffuse_evaluate(m, omega_o, omega_i);
}

static inline float3 brdf_albedo(global const Material *m, float3 omega_o) {
    MATERIAL_MODELS(BRDF_ALBEDO)
    return diffuse_albedo(m, omega_o);
}

static inline float3 brdf_sample(global const Material *m, float3 omega_o, float2 u) {
    MATERIAL_MODELS(BRDF_SAMPLE)
    return diffuse_sample(m, omega_o, u);
}

static inline float brdf_pdf(global const Material *m, float3 omega_o, float3 omega_i) {
    MATERIAL_MODELS(BRDF_PDF)
    return diffuse_pdf(m, omega_o, omega_i);
}

// Scattering K of light that is known by its irradiance E alone, not by its directions, for a surface of this albedo: exact for the diffuse
// model. It stands in three forms, each with the order of multiplications that its callers were measured and compared with, since every
// other order rounds differently.

/// Radiance albedo E / pi [W m^-2 sr^-1] of one point.
static inline float3 brdf_reflect(float3 albedo, float3 irradiance) { return albedo * irradiance * M_1_PI_F; }

/// The same for one channel of a packet: 1 / pi goes to the albedo, which is there before the irradiance is.
static inline vfloat brdf_reflect_packet(vfloat albedo, vfloat irradiance) { return irradiance * (M_1_PI_F * albedo); }

/// sum plus radiosity albedo E [W m^-2], pi times the radiance, for sums over texels of cosine-weighted solid angle pi / n^2, where pi
/// cancels. The sum is in the same expression, so that compilers may fuse product and sum.
static inline float4 brdf_add_radiosity(float4 sum, float4 albedo, float4 irradiance) { return sum + irradiance * albedo; }
