// Emission that chains of lobes end on, where no pencil sees it: of the film's reflections.

#include "lib/chain_emission.cl"

/// launch : 1-D, one work-item per surfel
/// in     : surfels (follow_surfels); materials; the environment
/// in/out : radiance[3][capacity] [W m^-2 sr^-1], added to
kernel void emit_chains(global const float *surfels, int capacity, int surfel_count, global const Material *materials, SKY_PARAMETERS,
                        global float *radiance) {
    int i = get_global_id(0);
    if (i < surfel_count) add_chain_emission(surfels, capacity, i, materials, sky, sky_texels, radiance);
}
