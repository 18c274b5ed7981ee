// Emission at the end of a chain of lobes (follow_surfels.cl), or of the sky where a ray has met nothing.

#include "lib/emission.cl"
#include "lib/sky.cl"
#include "shared/material.h"
#include "shared/surfel.h"

/// Adds what surfel i carries to radiance[3][capacity].
static inline void add_chain_emission(global const float *surfels, size_t c, int i, global const Material *materials, SKY_PARAMETERS,
                                      global float *radiance) {
    global const float *s = surfels + i;
    float3 emission = (float3)(0.0f);
    if (SURFEL_CONST_INT(s, SURFEL_PLANE * c) < 0) {
        // In place of the share: the density of the ray's direction, as sky_radiance has it.
        if (PENCIL_SKY)
            emission = sky_radiance(sky, sky_texels, -(float3)(s[SURFEL_OX * c], s[SURFEL_OY * c], s[SURFEL_OZ * c]), s[SURFEL_SHARE * c]);
    } else {
        emission = s[SURFEL_SHARE * c] * surfel_emission(surfels, c, i, materials);
    }
    radiance[i] += s[SURFEL_TR * c] * emission.x;
    radiance[c + i] += s[SURFEL_TG * c] * emission.y;
    radiance[2 * c + i] += s[SURFEL_TB * c] * emission.z;
}
