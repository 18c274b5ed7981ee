// Lommel and Seeliger's reflection, of dark and dusty surfaces such as the Moon's: light enters a layer of grains and is scattered once,
// evenly in all directions. albedo of the row: that of a grain.

#include "lib/bsdf_point.cl"

/// At grazing angles it is far from even: all of it is a lobe.
static inline float3 seeliger_base(const Bsdf *b, float3 omega_o) { return (float3)(0.0f); }

static inline float seeliger_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) { return 1.0f; }

/// Integral of evaluate: albedo / 2 (1 - c log(1 + 1 / c)), c = cos_o.
static inline float3 seeliger_share(const Bsdf *b, float3 omega_o) {
    float c = omega_o.z;
    return b->albedo * (0.5f * (1.0f - c * log1p(1.0f / c)));
}

/// f cos_i = albedo / (4 pi) cos_i / (cos_o + cos_i) [1/sr].
static inline float3 seeliger_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (!(omega_i.z > 0.0f)) return (float3)(0.0f);
    return b->albedo * (0.25f * M_1_PI_F * omega_i.z / (omega_o.z + omega_i.z));
}

/// By the cosine, since f is broad: cos_i / pi [1/sr].
static inline float seeliger_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) { return fmax(omega_i.z, 0.0f) * M_1_PI_F; }

static inline BsdfSample seeliger_sample(const Bsdf *b, float3 omega_o, float3 u) {
    float radius = sqrt(u.x), phi = 2.0f * M_PI_F * u.y;
    BsdfSample s = {(float3)(radius * cos(phi), radius * sin(phi), sqrt(1.0f - u.x)), (float3)(0.0f), 0.0f};
    s.pdf = seeliger_pdf(b, omega_o, s.omega_i);
    if (!(s.pdf > 0.0f)) return no_bsdf_sample();
    s.weight = seeliger_evaluate(b, omega_o, s.omega_i) / s.pdf;
    return s;
}
