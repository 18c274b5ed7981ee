// What models of scattering know of a point of a surface.

#include "shared/material.h"

typedef struct Bsdf {
    int model, flags;
    float3 albedo;                 // diffuse reflectance, base colour
    float3 specular, transmitted;  // factors
    float3 eta, k;                 // eta of dielectrics: index of the far side over that of the near side
    float alpha;                   // roughness
    float exponent;                // phong
    int varnish;                   // plastic: first texel of its table
    global const half *tables;
    float metallic, spec_trans, clearcoat, clearcoat_gloss;  // principled
} Bsdf;

typedef struct BsdfSample {
    float3 omega_i;
    float3 weight;  // 0: there is no direction
    float pdf;      // 0: of a lobe without width
} BsdfSample;

static inline BsdfSample no_bsdf_sample(void) {
    BsdfSample none = {(float3)(0.0f, 0.0f, 1.0f), (float3)(0.0f), 1.0f};
    return none;
}
