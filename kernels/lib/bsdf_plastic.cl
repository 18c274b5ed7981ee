// A diffuse base under a clear boundary, smooth or of microfacets. Light that the base reflects is reflected back to it inside, again and again
// (Jakob, Mitsuba 0.6 documentation, "plastic").

#include "lib/bsdf_point.cl"
#include "lib/fresnel.cl"
#include "lib/microfacet.cl"

static inline float plastic_reflects(const Bsdf *b, float cosine) {
    float refracted;
    return fresnel_dielectric(cosine, b->eta.x, &refracted);
}

/// Of the table of a rough varnish, at this column.
static inline float plastic_table(const Bsdf *b, float column, int component) {
    float row = clamp((b->alpha - b->k.x) * b->k.y, 0.0f, VARNISH_ROWS - 1.0f);
    int r = min((int)row, VARNISH_ROWS - 2), c = min((int)column, VARNISH_COLUMNS - 2);
    size_t at = 4 * ((size_t)b->varnish + r * VARNISH_COLUMNS + c) + component, below = at + 4 * VARNISH_COLUMNS;
    float x = column - c, y = row - r;
    return mix(mix(vload_half(at, b->tables), vload_half(at + 4, b->tables), x),
               mix(vload_half(below, b->tables), vload_half(below + 4, b->tables), x), y);
}

/// Share of light that passes the varnish at this cosine outside.
static inline float plastic_passes(const Bsdf *b, float cosine) {
    float refracted;
    if (b->alpha < SMOOTH_ALPHA) return 1.0f - fresnel_dielectric(cosine, b->eta.x, &refracted);
    return plastic_table(b, clamp(cosine, 0.0f, 1.0f) * (VARNISH_COLUMNS - 2), 0);
}

/// Its mean for even light.
static inline float plastic_passes_even(const Bsdf *b) { return plastic_table(b, VARNISH_COLUMNS - 1, 0); }

/// Share of even light from inside that the varnish reflects back (Mitsuba: by single scattering, which for rough varnish loses some).
static inline float plastic_keeps(const Bsdf *b) { return plastic_table(b, VARNISH_COLUMNS - 1, 1); }

static inline float3 plastic_base(const Bsdf *b, float3 omega_o) {
    float3 back = plastic_keeps(b) * (b->flags & MATERIAL_NONLINEAR ? b->albedo : (float3)(1.0f));
    return b->albedo * (plastic_passes(b, omega_o.z) * plastic_passes_even(b) / (b->eta.x * b->eta.x)) / (1.0f - back);
}

static inline float plastic_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) {
    return plastic_passes(b, omega_i.z) / plastic_passes_even(b);
}

static inline float3 plastic_share(const Bsdf *b, float3 omega_o) { return b->specular * (1.0f - plastic_passes(b, omega_o.z)); }

static inline float3 plastic_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (b->alpha < SMOOTH_ALPHA || !(omega_i.z > 0.0f)) return (float3)(0.0f);
    float3 h = normalize(omega_o + omega_i);
    return b->specular *
           (plastic_reflects(b, dot(omega_o, h)) * microfacet_reflect(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, omega_i, h));
}

static inline float plastic_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (b->alpha < SMOOTH_ALPHA || !(omega_i.z > 0.0f)) return 0.0f;
    return microfacet_reflect_pdf(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, omega_i);
}

static inline BsdfSample plastic_sample(const Bsdf *b, float3 omega_o, float3 u) {
    BsdfSample s = {(float3)(-omega_o.xy, omega_o.z), (float3)(0.0f), 0.0f};
    if (b->alpha < SMOOTH_ALPHA) {
        s.weight = plastic_share(b, omega_o);
        return s;
    }
    s.omega_i = microfacet_mirror(b->flags & MATERIAL_BECKMANN, b->alpha, omega_o, u.xy);
    s.pdf = plastic_pdf(b, omega_o, s.omega_i);
    if (!(s.omega_i.z > 0.0f && s.pdf > 0.0f)) return no_bsdf_sample();
    s.weight = plastic_evaluate(b, omega_o, s.omega_i) / s.pdf;
    return s;
}
