// What surfaces do with light: one row per material, and the models of reflection that a row may name.
#pragma once

#include "shared/types.h"

// Models of reflection beside the diffuse one: MODEL(PHONG, phong) for each. From this list come the numbers below, the calls in
// kernels/lib/brdf.cl and host/reference/brdf.h, and the defines that leave out what a scene does not have. The functions of a model are in
// kernels/lib/brdf_phong.cl, and once more in host/reference/brdf_phong.cpp.
#define MATERIAL_MODELS(MODEL)

PENCIL_SHARED_BEGIN

#define MATERIAL_NUMBER(NAME, name) , MATERIAL_##NAME
enum { MATERIAL_DIFFUSE MATERIAL_MODELS(MATERIAL_NUMBER) };  // Material.model

typedef struct Material {
    float4 albedo;    // rgb: diffuse reflectance in [0, 1]; w: 1 if both sides reflect, else 0
    float4 emission;  // rgb: emitted radiance of the front side [W m^-2 sr^-1]; w: 1 if the pencil maps carry it (thesis 6.1.3)
    //------------------------------------------------- 32 B
    int model;            // MATERIAL_...
    float parameters[3];  // of the model; the diffuse one has none
    //------------------------------------------------- 48 B
} Material;
PENCIL_SHARED_TYPE(Material)

PENCIL_SHARED_END
