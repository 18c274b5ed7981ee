// What surfaces do with light: one row per material, and the models of reflection that a row may name.
#pragma once

#include "shared/types.h"

// Models, the values of Material.model: each is kernels/lib/brdf_<name>.cl behind kernels/lib/brdf.cl.
#define MATERIAL_DIFFUSE 0  // brdf_diffuse.cl

PENCIL_SHARED_BEGIN

typedef struct Material {
    float4 albedo;    // rgb: diffuse reflectance in [0, 1]; w: 1 if both sides reflect, else 0
    float4 emission;  // rgb: emitted radiance of the front side [W m^-2 sr^-1]; w: 1 if the pencil maps carry it (thesis 6.1.3)
    //------------------------------------------------- 32 B
    int model;  // MATERIAL_...
    int unused[3];
    //------------------------------------------------- 48 B
} Material;

PENCIL_SHARED_END
