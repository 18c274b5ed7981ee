// Metals: microfacets that reflect by the complex index of refraction (Walter et al. 2007; Cook and Torrance 1982), or a smooth mirror.

#include "lib/bsdf_point.cl"
#include "lib/fresnel.cl"
#include "lib/microfacet.cl"

static inline float3 conductor_fresnel(const Bsdf *b, float cosine) {
    return b->specular * (b->flags & MATERIAL_MIRROR ? (float3)(1.0f) : fresnel_conductor(cosine, b->eta, b->k));
}

static inline float3 conductor_base(const Bsdf *b, float3 omega_o) { return (float3)(0.0f); }

static inline float conductor_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) { return 1.0f; }

static inline float3 conductor_share(const Bsdf *b, float3 omega_o) { return conductor_fresnel(b, omega_o.z); }

static inline float3 conductor_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (b->alpha < SMOOTH_ALPHA || !(omega_i.z > 0.0f)) return (float3)(0.0f);
    float3 h = normalize(omega_o + omega_i);
    return conductor_fresnel(b, dot(omega_o, h)) * microfacet_reflect(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, omega_i, h);
}

static inline float conductor_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (b->alpha < SMOOTH_ALPHA || !(omega_i.z > 0.0f)) return 0.0f;
    return microfacet_reflect_pdf(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, omega_i);
}

static inline BsdfSample conductor_sample(const Bsdf *b, float3 omega_o, float3 u) {
    BsdfSample s = {(float3)(-omega_o.xy, omega_o.z), (float3)(0.0f), 0.0f};
    if (b->alpha < SMOOTH_ALPHA) {
        s.weight = conductor_fresnel(b, omega_o.z);
        return s;
    }
    s.omega_i = microfacet_mirror(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, u.xy);
    s.pdf = conductor_pdf(b, omega_o, s.omega_i);
    if (!(s.omega_i.z > 0.0f && s.pdf > 0.0f)) return no_bsdf_sample();
    s.weight = conductor_evaluate(b, omega_o, s.omega_i) / s.pdf;
    return s;
}
