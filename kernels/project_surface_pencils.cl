// Local projection R and scattering K: the irradiance of the surface pencils near each surfel, reflected.

#include "lib/brdf.cl"
#include "lib/pencil_grid.cl"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// launch : 1-D, one work-item per surfel
/// in     : surfels; pencils, their irradiance and their grid
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to
/// needs  : surfels that no pencil may stand for receive nothing
kernel void project_surface_pencils(global const float *surfels, int capacity, int surfel_count, global const SurfacePencil *pencils,
                                    global const float4 *irradiance, PencilGrid grid, global const int *starts, global const float *entries,
                                    global float *outgoing) {
    int i = get_global_id(0);
    if (i >= surfel_count) return;
    size_t c = capacity;
    global const float *s = surfels + i;
    if (as_int(s[SURFEL_PLANE * c]) < 0) return;
    float3 x = (float3)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c]),
           n = (float3)(s[SURFEL_NX * c], s[SURFEL_NY * c], s[SURFEL_NZ * c]);
    float3 albedo = (float3)(s[SURFEL_ALBEDO_R * c], s[SURFEL_ALBEDO_G * c], s[SURFEL_ALBEDO_B * c]);
    if (!any(albedo > 0.0f)) return;
    float3 radiance = brdf_reflect(albedo, linked_irradiance(irradiance, nearest_pencils(pencils, grid, starts, entries, x, n)));
    outgoing[i] += radiance.x;
    outgoing[c + i] += radiance.y;
    outgoing[2 * c + i] += radiance.z;
}
