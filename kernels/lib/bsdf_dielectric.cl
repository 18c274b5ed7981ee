// Boundaries of clear things: smooth, rough by microfacets (Walter et al. 2007), or two of them that lie so near each other that light goes on
// unturned. Radiance that passes a boundary is scaled by the square of the indices' ratio.

#include "lib/bsdf_point.cl"
#include "lib/fresnel.cl"
#include "lib/microfacet.cl"

static inline float3 dielectric_base(const Bsdf *b, float3 omega_o) { return (float3)(0.0f); }

static inline float dielectric_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) { return 1.0f; }

static inline float3 dielectric_share(const Bsdf *b, float3 omega_o) { return fmax(b->specular, b->transmitted); }

static inline bool dielectric_is_smooth(const Bsdf *b) { return b->alpha < SMOOTH_ALPHA || b->flags & MATERIAL_THIN; }

/// Microfacet normal, above the surface, that turns omega_o into omega_i.
static inline float3 dielectric_half(const Bsdf *b, float3 omega_o, float3 omega_i) {
    float3 h = normalize(omega_o + omega_i * (omega_i.z > 0.0f ? 1.0f : b->eta.x));
    return h.z < 0.0f ? -h : h;
}

static inline float3 dielectric_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (dielectric_is_smooth(b) || omega_i.z == 0.0f) return (float3)(0.0f);
    bool beckmann = b->flags & MATERIAL_BECKMANN;
    float3 h = dielectric_half(b, omega_o, omega_i);
    float o = dot(omega_o, h), i = dot(omega_i, h), refracted;
    float reflected = fresnel_dielectric(o, b->eta.x, &refracted);
    if (omega_i.z > 0.0f) return b->specular * (reflected * microfacet_reflect(beckmann, b->alpha, omega_o, omega_i, h));
    if (!(o > 0.0f && i < 0.0f)) return (float3)(0.0f);
    float root = o + b->eta.x * i;
    float seen = microfacet_seen(beckmann, b->alpha, omega_o, h) * microfacet_seen(beckmann, b->alpha, omega_i, h);
    // Walter et al., eq. (21), times |cos_i| and, for radiance, 1 / eta^2.
    return b->transmitted *
           ((1.0f - reflected) * microfacet_density(beckmann, b->alpha, h) * seen * fabs(i * o / omega_o.z) / (root * root));
}

static inline float dielectric_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (dielectric_is_smooth(b) || omega_i.z == 0.0f) return 0.0f;
    float3 h = dielectric_half(b, omega_o, omega_i);
    float o = dot(omega_o, h), i = dot(omega_i, h), refracted;
    if (!(o > 0.0f)) return 0.0f;
    float reflected = fresnel_dielectric(o, b->eta.x, &refracted), root = o + b->eta.x * i;
    float density = microfacet_pdf(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, h);
    if (omega_i.z > 0.0f) return reflected * density / (4.0f * o);
    return i < 0.0f ? (1.0f - reflected) * density * b->eta.x * b->eta.x * fabs(i) / (root * root) : 0.0f;
}

static inline BsdfSample dielectric_sample(const Bsdf *b, float3 omega_o, float3 u) {
    bool smooth = dielectric_is_smooth(b);
    float3 h = smooth ? (float3)(0.0f, 0.0f, 1.0f) : microfacet_sample(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, u.xy);
    float o = dot(omega_o, h), refracted, reflected = fresnel_dielectric(o, b->eta.x, &refracted);
    if (b->flags & MATERIAL_THIN) reflected *= 2.0f / (1.0f + reflected);  // back and forth between the two boundaries
    bool passes = u.z >= reflected;
    BsdfSample s = {2.0f * o * h - omega_o, b->specular, 0.0f};
    if (passes) {
        bool thin = b->flags & MATERIAL_THIN;
        float inverse = 1.0f / b->eta.x;
        s.omega_i = thin ? -omega_o : (o * inverse - refracted) * h - inverse * omega_o;
        s.weight = b->transmitted * (thin ? 1.0f : inverse * inverse);
    }
    if (smooth) return s;
    s.pdf = dielectric_pdf(b, omega_o, s.omega_i);
    if (!(s.pdf > 0.0f) || passes != s.omega_i.z < 0.0f) return no_bsdf_sample();
    s.weight = dielectric_evaluate(b, omega_o, s.omega_i) / s.pdf;
    return s;
}
