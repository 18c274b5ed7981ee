// Oren and Nayar's model of rough matte surfaces (1994, eqs. 27 to 30: light that facets scatter once or twice), as Mitsuba's roughdiffuse: all
// of it is base.

#include "lib/bsdf_point.cl"

/// What facets scatter once, and twice for each unit of albedo, beside a smooth surface: for the angles of both directions to the normal and,
/// of the azimuth between them, its cosine, its cosine where that is positive, and its cosine's size.
static inline float2 rough_diffuse_facets(const Bsdf *b, float theta_o, float theta_i, float cosine, float positive, float size) {
    float square = 0.5f * b->alpha * b->alpha, spread = square / (square + 0.09f);  // deviation of slopes from Beckmann's roughness
    float wide = fmax(theta_o, theta_i), narrow = fmin(theta_o, theta_i);
    float n = 2.0f * M_1_PI_F * narrow, wn = n * 2.0f * M_1_PI_F * wide;
    float once = 1.0f - 0.5f * square / (square + 0.33f);
    once += 0.45f * spread * tan(narrow) * (cosine * sin(wide) - (cosine - positive) * n * n * n);
    once += 0.125f * spread * wn * wn * (1.0f - size) * tan(0.5f * (wide + narrow));
    return (float2)(once, 0.17f * square / (square + 0.13f) * (1.0f - cosine * n * n));
}

static inline float rough_diffuse_angle(float3 v) { return acos(clamp(v.z, 1e-3f, 1.0f)); }

/// By the Gauss-Jacobi rule for the weight 2 x.
static inline float3 rough_diffuse_base(const Bsdf *b, float3 omega_o) {
    const float angle[4] = {1.43057744f, 1.14130369f, 0.76243406f, 0.33957654f};  // of cosines 0.13976, 0.41641, 0.72316, 0.94290
    const float weight[4] = {0.06236194f, 0.25969510f, 0.40692914f, 0.27101383f};
    float2 sum = (float2)(0.0f);
    for (int k = 0; k < 4; ++k)
        sum += weight[k] * rough_diffuse_facets(b, rough_diffuse_angle(omega_o), angle[k], 0.0f, M_1_PI_F, 2.0f * M_1_PI_F);
    return b->albedo * (sum.x + sum.y * b->albedo);
}

/// By the sum of the channels, since colours hardly differ.
static inline float rough_diffuse_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) {
    float square = (1.0f - omega_o.z * omega_o.z) * (1.0f - omega_i.z * omega_i.z);
    float cosine = square > 1e-8f ? (omega_o.x * omega_i.x + omega_o.y * omega_i.y) * rsqrt(square) : 0.0f;
    float2 f =
        rough_diffuse_facets(b, rough_diffuse_angle(omega_o), rough_diffuse_angle(omega_i), cosine, fmax(cosine, 0.0f), fabs(cosine));
    float3 own = b->albedo * (f.x + f.y * b->albedo), even = rough_diffuse_base(b, omega_o);
    float sum = even.x + even.y + even.z;
    return sum > 0.0f ? (own.x + own.y + own.z) / sum : 1.0f;
}

static inline float3 rough_diffuse_share(const Bsdf *b, float3 omega_o) { return (float3)(0.0f); }

static inline float3 rough_diffuse_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) { return (float3)(0.0f); }

static inline float rough_diffuse_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) { return 0.0f; }

static inline BsdfSample rough_diffuse_sample(const Bsdf *b, float3 omega_o, float3 u) { return no_bsdf_sample(); }
