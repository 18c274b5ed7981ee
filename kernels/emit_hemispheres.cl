// Emission that surface pencils see. Light samples weigh 1/r^2 by r^2 / (r^2 + A/pi) (light_sample.cl); what that leaves out, near an
// emitter, is seen here: the two shares of every emitter's light add up to all of it, and neither is unbounded.

#include "lib/chain_emission.cl"
#include "shared/material.h"
#include "shared/surface_pencil.h"
#include "shared/surfel.h"

/// launch : 1-D, one work-item per surfel of pencils first_pencil .. , `rays` entries per pencil
/// in     : surfels (trace_hemispheres); pencils; materials; near_area[material]: A/pi of the emitter's light samples [scene units^2],
///          INFINITY if it has none; the environment
/// in/out : radiance[3][capacity]: emission times (A/pi) / (r^2 + A/pi) is added where the front of an emitter is seen
kernel void emit_hemispheres(global const float *surfels, int capacity, int surfel_count, global const SurfacePencil *pencils,
                             int first_pencil, int rays, global const Material *materials, global const float *near_area, SKY_PARAMETERS,
                             global float *radiance) {
    int i = get_global_id(0);
    if (i >= surfel_count) return;
    size_t c = capacity;
    global const float *s = surfels + i;
    if (PENCIL_OUTGOING && (s[SURFEL_SHARE * c] >= 0.0f || SURFEL_CONST_INT(s, SURFEL_PLANE * c) < 0)) {
        add_chain_emission(surfels, c, i, materials, sky, sky_texels, radiance);
        return;
    }
    float3 emission = surfel_emission(surfels, c, i, materials);
    if (!any(emission > 0.0f)) return;
    int m = SURFEL_CONST_INT(s, SURFEL_MATERIAL * c);
    float3 step = (float3)(s[SURFEL_X * c], s[SURFEL_Y * c], s[SURFEL_Z * c]) - pencils[first_pencil + i / rays].position.xyz;
    float share = near_area[m] < INFINITY ? near_area[m] / (dot(step, step) + near_area[m]) : 1.0f;
    if (PENCIL_CLEAR) emission *= (float3)(s[SURFEL_TR * c], s[SURFEL_TG * c], s[SURFEL_TB * c]);  // seen through clear things
    radiance[i] += share * emission.x;
    radiance[c + i] += share * emission.y;
    radiance[2 * c + i] += share * emission.z;
}
