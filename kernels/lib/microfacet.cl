// Distributions of microfacets of roughness alpha, Beckmann's and GGX, with Smith's masking (Walter et al. 2007), in the frame of the surface.

/// Below this surfaces are smooth: lobes have no width.
#define SMOOTH_ALPHA 1e-4f

/// Density D(h) of microfacet normals per solid angle [1/sr].
static inline float microfacet_density(bool beckmann, float alpha, float3 h) {
    if (!(h.z > 0.0f)) return 0.0f;
    float c = h.z * h.z, a = alpha * alpha, tangent = (1.0f - c) / (c * a);
    if (beckmann) return exp(-tangent) / (M_PI_F * a * c * c);
    float root = c * a * (1.0f + tangent);  // GGX: a / (pi (c (a - 1) + 1)^2)
    return a / (M_PI_F * root * root);
}

/// Share G1(v) of microfacets that are seen from v; h: the normal of one of them.
static inline float microfacet_seen(bool beckmann, float alpha, float3 v, float3 h) {
    float z = fabs(v.z);
    if (!(dot(v, h) * v.z > 0.0f)) return 0.0f;
    float tangent = sqrt(fmax(1.0f - z * z, 0.0f)) / z, t = alpha * tangent;
    if (!beckmann) return 2.0f / (1.0f + sqrt(1.0f + t * t));
    float a = 1.0f / t;
    return a >= 1.6f ? 1.0f : (3.535f * a + 2.181f * a * a) / (1.0f + 2.276f * a + 2.577f * a * a);
}

/// A microfacet normal for u in [0, 1)^2. GGX: of those that v, above the surface, sees (Heitz 2018); Beckmann: of all, by D cos.
static inline float3 microfacet_sample(bool beckmann, float alpha, float3 v, float2 u) {
    if (beckmann) {
        float square = -alpha * alpha * log(1.0f - u.x), z = rsqrt(1.0f + square), r = sqrt(fmax(1.0f - z * z, 0.0f));
        float phi = 2.0f * M_PI_F * u.y;
        return (float3)(r * cos(phi), r * sin(phi), z);
    }
    float3 s = normalize((float3)(alpha * v.x, alpha * v.y, v.z));
    float flat = s.x * s.x + s.y * s.y;
    float3 t = flat > 0.0f ? (float3)(-s.y, s.x, 0.0f) * rsqrt(flat) : (float3)(1.0f, 0.0f, 0.0f), b = cross(s, t);
    float r = sqrt(u.x), phi = 2.0f * M_PI_F * u.y, x = r * cos(phi), y = r * sin(phi), w = 0.5f * (1.0f + s.z);
    y = (1.0f - w) * sqrt(fmax(1.0f - x * x, 0.0f)) + w * y;
    float3 n = x * t + y * b + sqrt(fmax(1.0f - x * x - y * y, 0.0f)) * s;
    return normalize((float3)(alpha * n.x, alpha * n.y, fmax(n.z, 1e-6f)));
}

/// Density of microfacet_sample per solid angle of normals [1/sr].
static inline float microfacet_pdf(bool beckmann, float alpha, float3 v, float3 h) {
    float d = microfacet_density(beckmann, alpha, h);
    return beckmann ? d * h.z : microfacet_seen(beckmann, alpha, v, h) * fmax(dot(v, h), 0.0f) * d / v.z;
}

/// Density of the mirror direction of a microfacet_sample, per solid angle [1/sr].
static inline float microfacet_reflect_pdf(bool beckmann, float alpha, float3 omega_o, float3 omega_i) {
    float3 h = normalize(omega_o + omega_i);
    return microfacet_pdf(beckmann, alpha, omega_o, h) / (4.0f * dot(omega_o, h));
}

/// The mirror direction of a microfacet_sample.
static inline float3 microfacet_mirror(bool beckmann, float alpha, float3 omega_o, float2 u) {
    float3 h = microfacet_sample(beckmann, alpha, omega_o, u);
    return 2.0f * dot(omega_o, h) * h - omega_o;
}

/// D G1 G1 / (4 cos_o): reflection by microfacets of reflectance 1, times the cosine of omega_i [1/sr]; h: their half vector.
static inline float microfacet_reflect(bool beckmann, float alpha, float3 omega_o, float3 omega_i, float3 h) {
    return microfacet_density(beckmann, alpha, h) * microfacet_seen(beckmann, alpha, omega_o, h) *
           microfacet_seen(beckmann, alpha, omega_i, h) / (4.0f * omega_o.z);
}
