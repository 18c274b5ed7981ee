// Reflection by the model of a material: every kernel that reflects light asks here, no other file knows which models there are. Needs
// packet.cl, shared/material.h and the brdf_<model>.cl. Directions are unit vectors in the local frame of the side that was seen, z along
// the shading normal; omega_o, towards where the light goes, comes first, omega_i, towards where it comes from, second. A model has
//   evaluate(m, omega_o, omega_i)   f [1/sr], reciprocal; 0 where a direction is not above the horizon
//   albedo(m, omega_o)              integral of f(omega_o, omega) cos d omega over the hemisphere, at most 1
//   sample(m, omega_o, u)           omega_i for u in [0, 1)^2
//   pdf(m, omega_o, omega_i)        density of sample per solid angle [1/sr]
// A new model is a line like this in each of the four, PENCIL_PHONG a define of device/features.cpp: 1 if a material of the scene has it,
//   if (PENCIL_PHONG && m->model == MATERIAL_PHONG) return phong_evaluate(m, omega_o, omega_i);
// so that kernels of scenes without it are the same to the last instruction. docs/adding_a_material.md is the way through all files.

#include "lib/brdf_diffuse.cl"
#include "lib/packet.cl"
#include "shared/material.h"

static inline float3 brdf_evaluate(global const Material *m, float3 omega_o, float3 omega_i) {
    return diffuse_evaluate(m, omega_o, omega_i);
}

static inline float3 brdf_albedo(global const Material *m, float3 omega_o) { return diffuse_albedo(m, omega_o); }

static inline float3 brdf_sample(global const Material *m, float3 omega_o, float2 u) { return diffuse_sample(m, omega_o, u); }

static inline float brdf_pdf(global const Material *m, float3 omega_o, float3 omega_i) { return diffuse_pdf(m, omega_o, omega_i); }

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
