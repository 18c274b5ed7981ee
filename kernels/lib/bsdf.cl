// Scattering by the model of a material. Directions are unit vectors in the local frame of the side that was seen, z along the shading normal:
// omega_o, towards where the light goes, comes first and is above the surface; omega_i, towards where it comes from, may be below, for light
// that passes through. What a surface scatters is the sum of
//   its base    close to even in all directions of the upper hemisphere, so that irradiance says what it reflects
//   its lobes   all else: light is followed along them, or comes from light samples that they are evaluated for
// A model has
//   base(b, omega_o)                albedo of the base, for even light
//   base_factor(b, omega_o, omega_i)  what light from omega_i counts beside even light; 1 in the mean over the hemisphere with its cosine
//   share(b, omega_o)               about how much of the light the lobes scatter, to choose by
//   evaluate(b, omega_o, omega_i)   lobes, times |cos_i| [1/sr]; without those of no width
//   pdf(b, omega_o, omega_i)        density of sample per solid angle [1/sr]; without the same
//   sample(b, omega_o, u, ...)      omega_i for u in [0, 1)^3, with its weight, lobes |cos_i| / density, and its density, 0: no width
// A model enters the list MATERIAL_MODELS of shared/material.h; its file is found by its name. Kernels of scenes without it are the same to the
// last instruction: PENCIL_MODEL_<NAME> is 0 for them (device/features.cpp). docs/adding_a_material.md is the way through all files.

#include "lib/bsdf_*.cl"
#include "lib/bsdf_point.cl"
#include "shared/material.h"

#define BSDF_IS(NAME) (PENCIL_MODEL_##NAME && b->model == MATERIAL_##NAME)
#define BSDF_BASE(NAME, name) \
    if (BSDF_IS(NAME)) return name##_base(b, omega_o);
#define BSDF_BASE_FACTOR(NAME, name) \
    if (BSDF_IS(NAME)) return name##_base_factor(b, omega_o, omega_i);
#define BSDF_SHARE(NAME, name) \
    if (BSDF_IS(NAME)) return name##_share(b, omega_o);
#define BSDF_EVALUATE(NAME, name) \
    if (BSDF_IS(NAME)) return name##_evaluate(b, omega_o, omega_i);
#define BSDF_PDF(NAME, name) \
    if (BSDF_IS(NAME)) return name##_pdf(b, omega_o, omega_i);
#define BSDF_SAMPLE(NAME, name) \
    if (BSDF_IS(NAME)) return name##_sample(b, omega_o, u);

/// True of light that passes unturned: it meets no vertex then.
static inline bool goes_straight(const Bsdf *b, const BsdfSample *s) {
    return b->model == MATERIAL_PASS || (b->model == MATERIAL_DIELECTRIC && b->flags & MATERIAL_THIN && s->omega_i.z < 0.0f);
}

static inline float3 bsdf_base(const Bsdf *b, float3 omega_o) {
    MATERIAL_MODELS(BSDF_BASE)
    return b->albedo;  // of diffuse surfaces; 0 of what lets all light through
}

static inline float bsdf_base_factor(const Bsdf *b, float3 omega_o, float3 omega_i) {
    MATERIAL_MODELS(BSDF_BASE_FACTOR)
    return 1.0f;
}

static inline float3 bsdf_share(const Bsdf *b, float3 omega_o) {
    MATERIAL_MODELS(BSDF_SHARE)
    return (float3)(b->model == MATERIAL_PASS ? 1.0f : 0.0f);
}

static inline float3 bsdf_evaluate(const Bsdf *b, float3 omega_o, float3 omega_i) {
    MATERIAL_MODELS(BSDF_EVALUATE)
    return (float3)(0.0f);
}

static inline float bsdf_pdf(const Bsdf *b, float3 omega_o, float3 omega_i) {
    MATERIAL_MODELS(BSDF_PDF)
    return 0.0f;
}

static inline BsdfSample bsdf_sample(const Bsdf *b, float3 omega_o, float3 u) {
    MATERIAL_MODELS(BSDF_SAMPLE)
    BsdfSample passed = {-omega_o, (float3)(b->model == MATERIAL_PASS ? 1.0f : 0.0f), 0.0f};
    return passed;
}
