// Scattering K at contacts (project_surface_pencils.cl): what pencils that were placed on some of them received, reflected.

#include "lib/brdf.cl"
#include "shared/surfel.h"

/// launch : 1-D, one work-item per pencil
/// in     : surfels; chosen[count]: the surfel that each pencil lies on, no two the same; counts[count]: contacts that it stands for;
///          irradiance[count]
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to
kernel void project_contacts(global const float *surfels, int capacity, global const int *chosen, global const float *counts, int count,
                             global const float4 *irradiance, global float *outgoing) {
    int item = get_global_id(0);
    if (item >= count) return;
    int i = chosen[item];
    size_t c = capacity;
    global const float *s = surfels + i;
    float3 albedo = (float3)(s[SURFEL_ALBEDO_R * c], s[SURFEL_ALBEDO_G * c], s[SURFEL_ALBEDO_B * c]);
    float3 radiance = counts[item] * brdf_reflect(albedo, irradiance[item].xyz);
    outgoing[i] += radiance.x;
    outgoing[c + i] += radiance.y;
    outgoing[2 * c + i] += radiance.z;
}
