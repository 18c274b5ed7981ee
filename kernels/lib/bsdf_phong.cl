// Phong's lobe about the mirror direction beside a diffuse base, normalised so that it is reciprocal and loses little (Lafortune and Willems
// 1994).

#include "lib/bsdf_point.cl"
#include "lib/hemisphere.cl"

static inline float3 phong_base(const Bsdf *b, float3 omega_o) { return b->albedo; }

static inline float phong_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) { return 1.0f; }

static inline float3 phong_share(const Bsdf *b, float3 omega_o) { return b->specular; }

/// Cosine to the power of the exponent, of the angle between omega_i and the mirror direction.
static inline float phong_power(const Bsdf *b, float3 omega_o, float3 omega_i) {
    float cosine = dot(omega_i, (float3)(-omega_o.xy, omega_o.z));
    return cosine > 0.0f ? pow(cosine, b->exponent) : 0.0f;
}

static inline float3 phong_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (!(omega_i.z > 0.0f)) return (float3)(0.0f);
    return b->specular * (0.5f * M_1_PI_F * (b->exponent + 2.0f) * phong_power(b, omega_o, omega_i) * omega_i.z);
}

static inline float phong_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (!(omega_i.z > 0.0f)) return 0.0f;
    return 0.5f * M_1_PI_F * (b->exponent + 1.0f) * phong_power(b, omega_o, omega_i);
}

static inline BsdfSample phong_sample(const Bsdf *b, float3 omega_o, float3 u) {
    float z = pow(u.x, 1.0f / (b->exponent + 1.0f)), r = sqrt(fmax(1.0f - z * z, 0.0f)), phi = 2.0f * M_PI_F * u.y;
    float3 mirror = (float3)(-omega_o.xy, omega_o.z), t, s;
    tangent_frame(mirror, &t, &s);
    BsdfSample found = {r * cos(phi) * t + r * sin(phi) * s + z * mirror, (float3)(0.0f), 0.0f};
    found.pdf = phong_pdf(b, omega_o, found.omega_i);
    if (!(found.omega_i.z > 0.0f && found.pdf > 0.0f)) return no_bsdf_sample();
    found.weight = phong_evaluate(b, omega_o, found.omega_i) / found.pdf;
    return found;
}
