// Local projection R and scattering K: the irradiance of the surface pencils near each surfel, reflected. Pencils are apart by their spacing;
// where a viewer sees something from nearer, between things that touch, it sees how wrong they are in between, and never averages it out.
// Such surfels, and those that no pencil reaches, are named instead: contacts, which gather for themselves (surface/contacts.h).

#include "lib/brdf.cl"
#include "lib/stand_in.cl"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// True if what is seen from `distance` away is too near for its pencils.
static inline bool is_contact(global const SurfacePencil *pencils, const PencilLinks *links, float distance, float nearness) {
    return links->index[0] < 0 || distance < nearness * pencils[links->index[0]].normal.w;
}

/// launch : 1-D, one work-item per surfel
/// in     : surfels; pencils, their irradiance and their grid; the hierarchy of the scene, for pencils that stand in; viewers[first_viewer ..]: who sees the surfels, `texels` of them each;
///          nearness: a contact is seen from nearer than this share of the radius of the pencil that counts most there, 0: there are none
/// out    : outgoing[3][capacity] [W m^-2 sr^-1], added to; contact[surfel_count]: 1 at contacts, which receive nothing here, else 0
/// needs  : surfels that no pencil may stand for receive nothing
kernel void project_surface_pencils(global const float *surfels, int capacity, int surfel_count, global const SurfacePencil *pencils,
                                    global const float4 *irradiance, PencilGrid grid, global const int *starts, global const float *entries,
                                    HIERARCHY_PARAMETERS, global const Triangle *triangles, global const float4 *planes,
                                    global const SurfacePencil *viewers, int first_viewer, int texels, float nearness,
                                    global float *outgoing, global uchar *contact) {
    int i = get_global_id(0);
    if (i >= surfel_count) return;
    contact[i] = 0;
    size_t c = capacity;
    global const float *s = surfels + i;
    int plane = SURFEL_CONST_INT(s, SURFEL_PLANE * c);
    if (plane < 0) return;
    float3 x = (float3)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c]),
           n = (float3)(s[SURFEL_NX * c], s[SURFEL_NY * c], s[SURFEL_NZ * c]);
    float3 albedo = (float3)(s[SURFEL_ALBEDO_R * c], s[SURFEL_ALBEDO_G * c], s[SURFEL_ALBEDO_B * c]);
    if (!any(albedo != 0.0f)) return;
    PencilLinks links;
    if (nearness > 0.0f) {
        links = reaching_pencils(pencils, grid, starts, entries, x, n);
        if (is_contact(pencils, &links, distance(x, viewers[first_viewer + i / texels].position.xyz), nearness)) {
            contact[i] = 1;
            return;
        }
    } else {
        links = nearest_pencils(pencils, grid, starts, entries, x, n, (float3)(s[SURFEL_GX * c], s[SURFEL_GY * c], s[SURFEL_GZ * c]), plane,
                                nodes, leaves, triangles, planes);
    }
    float3 radiance = brdf_reflect(albedo, linked_irradiance(irradiance, links));
    outgoing[i] += radiance.x;
    outgoing[c + i] += radiance.y;
    outgoing[2 * c + i] += radiance.z;
}
