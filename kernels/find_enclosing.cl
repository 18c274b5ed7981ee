// Finds centres of projection inside solids from their own geometry maps: inside a solid one sees the backs of its faces.

#include "lib/map.cl"
#include "lib/triangle.cl"
#include "shared/geometry.h"

/// Shape whose back a texel shows, -1 if it shows a front or nothing.
static inline int back_shape(Hit hit, global const Triangle *triangles, global const float4 *planes, float4 cop) {
    if (hit.triangle < 0) return -1;
    return plane_ahead(planes[triangles[hit.triangle].plane], cop) > 0.0f ? triangles[hit.triangle].shape : -1;
}

/// launch : 1-D, one work-item per tile
/// in     : hits of tile_count tiles of n x n, cops; triangles, planes
/// out    : enclosing[tile]: the shape whose backs fill more than half of all directions, or -1. Open-bottomed boxes that stand on a floor
///          are found as well as closed ones; a single wall fills at most half.
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void find_enclosing(global const Hit *hits, global const float4 *cops, int tile_count,
                                                                          int n, global const Triangle *triangles,
                                                                          global const float4 *planes, global int *enclosing) {
    int tile = get_global_id(0);
    if (tile >= tile_count) return;
    float4 cop = (float4)(cops[tile].xyz, 0.0f);
    // Majority vote (Boyer and Moore 1981), weighted: if one shape has the majority it is the candidate left.
    int candidate = -1;
    float lead = 0.0f;
    for (int i = 0; i < MAP_TEXELS(n); ++i) {
        int2 texel = map_texel_of_row(i % n, i / n, n);
        float weight = map_texel_solid_angle(texel, n);
        int shape = back_shape(hits[map_atlas_index(tile, texel, n)], triangles, planes, cop);
        if (shape == candidate) {
            lead += weight;
        } else if (weight <= lead) {
            lead -= weight;
        } else {
            candidate = shape;
            lead = weight - lead;
        }
    }
    float share = 0.0f;
    for (int i = 0; i < MAP_TEXELS(n); ++i) {
        int2 texel = map_texel_of_row(i % n, i / n, n);
        bool counts = back_shape(hits[map_atlas_index(tile, texel, n)], triangles, planes, cop) == candidate;
        share += counts ? map_texel_solid_angle(texel, n) : 0.0f;
    }
    enclosing[tile] = share > 2.0f * M_PI_F ? candidate : -1;
}
