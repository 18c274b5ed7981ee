// What surfaces do with light: one row per material, and the models of reflection that a row may name.
#pragma once

#include "shared/types.h"

// Models of scattering beside the diffuse one: MODEL(PHONG, phong) for each. From this list come the numbers below, the calls in
// kernels/lib/bsdf.cl and host/reference/bsdf.h, and the defines that leave out what a scene does not have. The functions of a model are in
// kernels/lib/bsdf_phong.cl, and once more in host/reference/bsdf_phong.cpp.
#define MATERIAL_MODELS(MODEL)    \
    MODEL(CONDUCTOR, conductor)   \
    MODEL(PLASTIC, plastic)       \
    MODEL(DIELECTRIC, dielectric) \
    MODEL(PHONG, phong)           \
    MODEL(PRINCIPLED, principled) \
    MODEL(ROUGH_DIFFUSE, rough_diffuse)

PENCIL_SHARED_BEGIN

#define MATERIAL_NUMBER(NAME, name) , MATERIAL_##NAME
// Material.model. Two are not models of scattering: BLEND is one of two other rows, chosen by its weight, PASS lets all light through unturned.
enum { MATERIAL_DIFFUSE MATERIAL_MODELS(MATERIAL_NUMBER), MATERIAL_BLEND, MATERIAL_PASS };

// Material.flags
#define MATERIAL_BECKMANN 1   // microfacets by Beckmann's distribution, not GGX
#define MATERIAL_NONLINEAR 2  // plastic: colour shifts by internal scattering
#define MATERIAL_THIN 4       // dielectric: light goes on unturned
#define MATERIAL_MIRROR 8     // conductor that reflects everything
#define MATERIAL_BUMP 16      // the normal texture holds heights
#define MATERIAL_OPACITY 32   // weight of a blend is the opacity of its texture
#define MATERIAL_CLEAR 64     // some light passes it unturned
#define MATERIAL_Y_UP 128     // y of the normal texture is against v, also where texture coordinates are mirrored

// Tables of what a rough varnish lets through: rows of equal steps of its roughness, or two of one roughness; columns of equal steps of the cosine from 0 to 1,
// then the mean over the hemisphere with its cosine, in the second component the share of even light from inside that is reflected.
#define VARNISH_ROWS 17
#define VARNISH_COLUMNS 34

typedef struct Material {
    float4 albedo;    // rgb: diffuse reflectance in [0, 1]; w: 1 if the back reflects, too, else 0
    float4 emission;  // rgb: emitted radiance of the front side [W m^-2 sr^-1]; w: 1 if the pencil maps carry it (thesis 6.1.3)
    //------------------------------------------------- 32 B
    int model;            // MATERIAL_...
    float parameters[3];  // of a model; those of principled: metallic, spec_trans, clearcoat
    //------------------------------------------------- 48 B
    float4 specular;     // rgb: factor of reflection by the boundary; w: roughness alpha
    float4 transmitted;  // rgb: factor of refraction; w: scale of the relief [scene units]
    float4 eta;          // rgb: index of refraction inside over outside; w: exponent of phong, flatness of principled
    float4 k;            // rgb: extinction of a conductor; plastic: x: alpha of the first row of its table, y: rows per unit of alpha;
                         // principled: sheen, its tint, tint of the specular reflection
    //------------------------------------------------- 112 B
    int flags;
    int back;            // row of a back that differs from the front, -1: none
    int first;           // blend: rows that it chooses from,
    int second;          // this one with probability weight
    float weight;        // times its texture
    int albedo_texture;  // -1: none, as for all
    int specular_texture;
    int alpha_texture;
    int weight_texture;
    int normal_texture;
    int emission_texture;
    int metallic_texture;
    float gloss;  // principled: of its clear coat
    int varnish;  // plastic: first texel of its table
    int unused_x;
    int unused_y;
    //------------------------------------------------- 176 B
    float4 glow;  // rgb: what the texture of the emission is multiplied by; emission is the mean
    //------------------------------------------------- 192 B
} Material;
PENCIL_SHARED_TYPE(Material)

PENCIL_SHARED_END
