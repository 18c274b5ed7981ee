// Finds which sides of which shapes each centre of projection sees. Centres that see a side in common lie in one connected space.

#include "lib/map.cl"
#include "lib/triangle.cl"
#include "shared/geometry.h"
#include "shared/material.h"
#include "shared/types.h"

/// launch : 1-D, one work-item per tile
/// in     : hits of tile_count tiles of n x n, cops; triangles, planes, materials
/// out    : sides[tile * words ..]: bit 2 s of the row is set if the tile shows the front of shape s, bit 2 s + 1 if it shows the back and
///          the back reflects. Backs of one-sided surfaces do not count: no light passes between them and a centre.
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void find_sides(global const Hit *hits, global const float4 *cops, int tile_count,
                                                                      int n, global const Triangle *triangles, global const float4 *planes,
                                                                      global const Material *materials, global uint *sides, int words) {
    int tile = get_global_id(0);
    if (tile >= tile_count) return;
    float4 cop = (float4)(cops[tile].xyz, 0.0f);
    global uint *row = sides + (size_t)tile * words;
    for (int w = 0; w < words; ++w) row[w] = 0;
    for (int i = 0; i < MAP_TEXELS(n); ++i) {
        Hit hit = hits[map_atlas_index(tile, map_texel_of_row(i % n, i / n, n), n)];
        if (hit.triangle < 0) continue;
        global const Triangle *t = triangles + hit.triangle;
        bool back = plane_ahead(planes[t->plane], cop) > 0.0f;
        if (back && materials[t->material].albedo.w == 0.0f) continue;
        int side = 2 * t->shape + (back ? 1 : 0);
        row[side / WORD_BITS] |= 1u << (side % WORD_BITS);
    }
}
