// Disney's principled BSDF (Burley 2012, 2015; parameters as in Mitsuba 3): a diffuse base with retro-reflection, sheen and flattening; a rough
// boundary between dielectric and metal, which may let light through; a clear coat. specular is the base colour; k: sheen, its tint, tint of
// the dielectric reflection; exponent: flatness. DEVIATION: anisotropy is left out.

#include "lib/bsdf_point.cl"
#include "lib/fresnel.cl"
#include "lib/microfacet.cl"

/// Base colour of luminance 1.
static inline float3 principled_tint(const Bsdf *b) {
    float luminance = dot(b->specular, (float3)(0.212671f, 0.715160f, 0.072169f));
    return luminance > 0.0f ? b->specular / luminance : (float3)(1.0f);
}

static inline bool principled_from_inside(const Bsdf *b) { return b->eta.x < 1.0f; }

static inline float principled_through(const Bsdf *b) { return (1.0f - b->metallic) * b->spec_trans; }

/// pi times the base for cosines c and i, r and its square in the mean: 2 roughness cos^2 of the angle to the half vector.
static inline float3 principled_diffuse(const Bsdf *b, float c, float i, float r, float rr) {
    float fo = schlick_weight(c), fi = schlick_weight(i), flatness = b->exponent;
    float f = (1.0f - 0.5f * fo) * (1.0f - 0.5f * fi) + r * (fo + fi - fo * fi) + rr * fo * fi;
    if (flatness > 0.0f) {
        float ss = (1.0f + fo * (0.5f * r - 1.0f)) * (1.0f + fi * (0.5f * r - 1.0f));
        f += flatness * (1.25f * (ss * (1.0f / (c + i) - 0.5f) + 0.5f) - f);
    }
    return b->specular * ((1.0f - b->metallic) * (1.0f - b->spec_trans) * f);
}

/// pi times the sheen, for a weight of the angle to the half vector.
static inline float3 principled_sheen(const Bsdf *b, float weight) {
    if (!(b->k.x > 0.0f)) return (float3)(0.0f);
    return (1.0f + b->k.y * (principled_tint(b) - 1.0f)) * (M_PI_F * b->k.x * (1.0f - b->metallic) * weight);
}

/// That weight in the mean over the azimuth; square: of the cosine to the half vector in the mean, swing: how far it goes up and down. By the
/// Gauss-Chebyshev rule.
static inline float principled_sheen_weight(float square, float swing) {
    float far = 0.86602540f * swing;
    return (schlick_weight(sqrt(square)) + schlick_weight(sqrt(fmax(square - far, 0.0f))) + schlick_weight(sqrt(square + far))) / 3.0f;
}

/// By the Gauss-Jacobi rule for the weight 2 x: the diffuse part, even in its azimuth but for r, is integrated exactly.
static inline float3 principled_base(const Bsdf *b, float3 omega_o) {
    if (principled_from_inside(b) || b->metallic >= 1.0f) return (float3)(0.0f);
    const float node[4] = {0.13975986f, 0.41640957f, 0.72315699f, 0.94289580f};
    const float weight[4] = {0.06236194f, 0.25969510f, 0.40692914f, 0.27101383f};
    float c = omega_o.z, rough = sqrt(b->alpha);
    float3 sum = (float3)(0.0f);
    for (int k = 0; k < 4; ++k) {
        float i = node[k], along = 1.0f + c * i, across = (1.0f - c * c) * (1.0f - i * i);
        sum += weight[k] * (principled_diffuse(b, c, i, rough * along, b->alpha * (along * along + 0.5f * across)) +
                            principled_sheen(b, principled_sheen_weight(0.5f * along, 0.5f * sqrt(across))));
    }
    return sum;
}

/// What light from omega_i counts beside even light: by the sum of the channels, since colours hardly differ.
static inline float principled_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) {
    float square = 0.5f * (1.0f + dot(omega_o, omega_i)), r = 2.0f * sqrt(b->alpha) * square;
    float3 even = principled_base(b, omega_o),
           own = principled_diffuse(b, omega_o.z, omega_i.z, r, r * r) + principled_sheen(b, schlick_weight(sqrt(square)));
    float sum = even.x + even.y + even.z;
    return sum > 0.0f ? (own.x + own.y + own.z) / sum : 1.0f;
}

/// Reflectance of the boundary.
static inline float3 principled_fresnel(const Bsdf *b, float cosine) {
    float refracted, clear = fresnel_dielectric(cosine, b->eta.x, &refracted);
    if (principled_from_inside(b)) return (float3)(principled_through(b) * clear);
    float weight = schlick_weight(cosine), tint = b->k.z, r = (b->eta.x - 1.0f) / (b->eta.x + 1.0f);
    float3 metal = b->specular + weight * (1.0f - b->specular), tinted = principled_tint(b) * (r * r);
    tinted += weight * (1.0f - tinted);
    return b->metallic * metal + (1.0f - b->metallic) * ((1.0f - tint) * clear + tint * tinted);
}

/// Clear coat: normals by GTR1 (Burley 2012, appendix B), index 1.5, a quarter as strong.
static inline float principled_coat_alpha(const Bsdf *b) { return mix(0.1f, 0.001f, b->clearcoat_gloss); }

static inline float principled_coat_density(float alpha, float3 h) {
    float a = alpha * alpha;
    return (a - 1.0f) / (M_PI_F * log(a) * (1.0f + (a - 1.0f) * h.z * h.z));
}

static inline float principled_coat_fresnel(const Bsdf *b, float cosine) {
    return 0.25f * b->clearcoat * (0.04f + 0.96f * schlick_weight(cosine));
}

static inline float3 principled_share(const Bsdf *b, float3 omega_o) {
    float3 f = principled_fresnel(b, omega_o.z);
    return fmin(f + principled_through(b) * (1.0f - f) * sqrt(b->specular) + principled_coat_fresnel(b, omega_o.z), (float3)(1.0f));
}

/// Microfacet normal, above the surface, that turns omega_o into omega_i.
static inline float3 principled_half(const Bsdf *b, float3 omega_o, float3 omega_i) {
    float3 h = normalize(omega_o + omega_i * (omega_i.z > 0.0f ? 1.0f : b->eta.x));
    return h.z < 0.0f ? -h : h;
}

static inline float3 principled_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (omega_i.z == 0.0f || (omega_i.z < 0.0f && !(principled_through(b) > 0.0f))) return (float3)(0.0f);
    float3 h = principled_half(b, omega_o, omega_i);
    float o = dot(omega_o, h), i = dot(omega_i, h), refracted;
    if (omega_i.z > 0.0f) {
        float3 f = principled_fresnel(b, o) * microfacet_reflect(false, b->alpha, omega_o, omega_i, h);
        if (b->clearcoat > 0.0f && !principled_from_inside(b))
            f += principled_coat_fresnel(b, o) * principled_coat_density(principled_coat_alpha(b), h) *
                 microfacet_seen(false, 0.25f, omega_o, h) * microfacet_seen(false, 0.25f, omega_i, h) * omega_i.z;
        return f;
    }
    if (!(o > 0.0f && i < 0.0f)) return (float3)(0.0f);
    float root = o + b->eta.x * i, passed = 1.0f - fresnel_dielectric(o, b->eta.x, &refracted);
    float seen = microfacet_seen(false, b->alpha, omega_o, h) * microfacet_seen(false, b->alpha, omega_i, h);
    return sqrt(b->specular) *
           (principled_through(b) * passed * microfacet_density(false, b->alpha, h) * seen * fabs(i * o / omega_o.z) / (root * root));
}

/// Chance of the coat among samples, and of reflection at a facet of dielectric reflectance f beside refraction.
static inline float principled_coat_chance(const Bsdf *b) {
    float weight = principled_from_inside(b) ? 0.0f : 0.25f * b->clearcoat;
    return weight / (1.0f + weight);
}

static inline float principled_reflects(const Bsdf *b, float f) {
    return principled_from_inside(b) ? f : 1.0f - principled_through(b) * (1.0f - f);
}

static inline float principled_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) {
    if (omega_i.z == 0.0f) return 0.0f;
    float3 h = principled_half(b, omega_o, omega_i);
    float o = dot(omega_o, h), i = dot(omega_i, h), coat = principled_coat_chance(b), refracted;
    if (!(o > 0.0f)) return 0.0f;
    float reflects = principled_reflects(b, fresnel_dielectric(o, b->eta.x, &refracted));
    float main = (1.0f - coat) * microfacet_pdf(false, b->alpha, omega_o, h);
    if (omega_i.z > 0.0f) return (reflects * main + coat * principled_coat_density(principled_coat_alpha(b), h) * h.z) / (4.0f * o);
    float root = o + b->eta.x * i;
    return i < 0.0f ? (1.0f - reflects) * main * b->eta.x * b->eta.x * fabs(i) / (root * root) : 0.0f;
}

static inline BsdfSample principled_sample(const Bsdf *b, float3 omega_o, float3 u) {
    float coat = principled_coat_chance(b);
    float3 h;
    if (u.z < coat) {
        float square = principled_coat_alpha(b) * principled_coat_alpha(b);
        float c = sqrt(fmax((1.0f - pow(square, 1.0f - u.x)) / (1.0f - square), 0.0f)), r = sqrt(fmax(1.0f - c * c, 0.0f));
        h = (float3)(r * cos(2.0f * M_PI_F * u.y), r * sin(2.0f * M_PI_F * u.y), c);
    } else {
        h = microfacet_sample(false, b->alpha, omega_o, u.xy);
    }
    float o = dot(omega_o, h), refracted, reflected = fresnel_dielectric(o, b->eta.x, &refracted), inverse = 1.0f / b->eta.x;
    bool passes = u.z >= coat && (u.z - coat) / (1.0f - coat) >= principled_reflects(b, reflected);
    BsdfSample s = {passes ? (o * inverse - refracted) * h - inverse * omega_o : 2.0f * o * h - omega_o, (float3)(0.0f), 0.0f};
    s.pdf = principled_pdf(b, omega_o, s.omega_i);
    if (!(o > 0.0f && s.pdf > 0.0f) || passes != s.omega_i.z < 0.0f) return no_bsdf_sample();
    s.weight = principled_evaluate(b, omega_o, s.omega_i) / s.pdf;
    return s;
}
