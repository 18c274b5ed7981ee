// Lambert's diffuse reflection: the same radiance in all directions, f = albedo / pi. The functions of a model (brdf.cl).

#include "shared/material.h"

/// BRDF f(omega_o, omega_i) = albedo / pi [1/sr], 0 unless both directions are above the horizon.
static inline float3 diffuse_evaluate(global const Material *m, float3 omega_o, float3 omega_i) {
    return omega_o.z > 0.0f && omega_i.z > 0.0f ? m->albedo.xyz * M_1_PI_F : (float3)(0.0f);
}

/// Share of light from omega_o that is reflected, integral of f(omega_o, omega) cos d omega over the hemisphere: the albedo itself.
static inline float3 diffuse_albedo(global const Material *m, float3 omega_o) {
    (void)omega_o;
    return m->albedo.xyz;
}

/// Direction omega_i for u in [0, 1)^2 with the density of diffuse_pdf: a uniform point of the unit disc, raised to the hemisphere
/// (Malley).
static inline float3 diffuse_sample(global const Material *m, float3 omega_o, float2 u) {
    (void)m;
    (void)omega_o;
    float radius = sqrt(u.x), phi = 2.0f * M_PI_F * u.y;
    return (float3)(radius * cos(phi), radius * sin(phi), sqrt(1.0f - u.x));
}

/// Density of diffuse_sample per solid angle, cos / pi [1/sr]; 0 below the horizon.
static inline float diffuse_pdf(global const Material *m, float3 omega_o, float3 omega_i) {
    (void)m;
    (void)omega_o;
    return fmax(omega_i.z, 0.0f) * M_1_PI_F;
}
