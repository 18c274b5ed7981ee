// Lommel and Seeliger's reflection, of dark and dusty surfaces such as the Moon's: light enters a layer of grains and is scattered once,
// evenly in all directions. albedo of the row: that of a grain.

#include "lib/brdf_diffuse.cl"
#include "shared/material.h"

/// BRDF f(omega_o, omega_i) = albedo / (4 pi) / (cos_o + cos_i) [1/sr], 0 unless both directions are above the horizon.
static inline float3 seeliger_evaluate(global const Material *m, float3 omega_o, float3 omega_i) {
    if (!(omega_o.z > 0.0f && omega_i.z > 0.0f)) return (float3)(0.0f);
    return m->albedo.xyz * (0.25f * M_1_PI_F / (omega_o.z + omega_i.z));
}

/// Share of light from omega_o that is reflected: albedo / 2 (1 - c log(1 + 1 / c)), c = cos_o.
static inline float3 seeliger_albedo(global const Material *m, float3 omega_o) {
    float c = omega_o.z, lost = c > 0.0f ? c * log1p(1.0f / c) : 0.0f;
    return m->albedo.xyz * (0.5f * (1.0f - lost));
}

/// Direction omega_i for u in [0, 1)^2: f is broad, so the density of the diffuse model serves it.
static inline float3 seeliger_sample(global const Material *m, float3 omega_o, float2 u) { return diffuse_sample(m, omega_o, u); }

/// Density of seeliger_sample per solid angle [1/sr].
static inline float seeliger_pdf(global const Material *m, float3 omega_o, float3 omega_i) { return diffuse_pdf(m, omega_o, omega_i); }
