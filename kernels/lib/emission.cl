// What surfels emit.

#include "shared/material.h"
#include "shared/surfel.h"

/// Emitted radiance of surfel i of surfels[][c] [W m^-2 sr^-1]; emitters are one-sided.
static inline float3 surfel_emission(global const float *surfels, size_t c, int i, global const Material *materials) {
    global const float *s = surfels + i;
    int m = SURFEL_CONST_INT(s, SURFEL_MATERIAL * c);
    if (m < 0 || m == PENCIL_NO_MATERIAL) return (float3)(0.0f);
    if (PENCIL_GLOW) return (float3)(s[SURFEL_ER * c], s[SURFEL_EG * c], s[SURFEL_EB * c]);
    return materials[m].emission.xyz;
}
