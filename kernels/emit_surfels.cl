// Emitted radiance of surfels: the initial gather of L_e (thesis 6.1.3), or the emission layer of the film.

#include "lib/emission.cl"

/// launch : 1-D, one work-item per surfel
/// in     : surfels; materials; carried_only 1: only emitters that the pencil maps carry (the "emission" form), 0: all
/// in/out : radiance[3][capacity], the emitted radiance of surfels seen from their front is added
kernel void emit_surfels(global const float *surfels, int capacity, int surfel_count, global const Material *materials, int carried_only,
                         global float *radiance) {
    int i = get_global_id(0);
    if (i >= surfel_count) return;
    float3 emission = surfel_emission(surfels, capacity, i, materials);
    if (!any(emission > 0.0f)) return;
    if (carried_only && materials[SURFEL_CONST_INT(surfels, (size_t)SURFEL_MATERIAL * capacity + i)].emission.w == 0.0f) return;
    radiance[i] += emission.x;
    radiance[(size_t)capacity + i] += emission.y;
    radiance[2 * (size_t)capacity + i] += emission.z;
}
