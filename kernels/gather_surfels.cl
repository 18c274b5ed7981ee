// Gather Q of a pencil: the surfels that its texels see (thesis eq. (5.1); h(c, -w) of eq. (5.14)).

#include "lib/map.cl"
#include "lib/surfel.cl"
#include "shared/geometry.h"
#include "shared/material.h"

/// launch : 1-D, one work-item per texel of `tile_count` tiles; surfels of a tile in the order of map_surfel_texel
/// in     : hits, cops, scene
/// out    : surfels, structure of arrays of `capacity`
kernel void gather_surfels(global const Hit *hits, global const float4 *cops, int first_tile, int tile_count, int n, SURFACES_PARAMETERS,
                           global float *surfels, int capacity) {
    int item = get_global_id(0);
    if (item >= tile_count * MAP_TEXELS(n)) return;
    int tile = first_tile + item / MAP_TEXELS(n);
    int2 texel = map_surfel_texel(item % MAP_TEXELS(n), n);
    float4 cop = (float4)(cops[tile].xyz, 0.0f);
    Surfaces scene = SURFACES;
    write_surfel(surfels, capacity, item, hits[map_atlas_index(tile, texel, n)], cop, map_texel_direction(texel, n), &scene,
                 hash_uint(hash_uint((uint)tile) + (uint)item));
}
