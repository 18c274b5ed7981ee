// Geometry maps: what each texel of each octahedral tile sees, by eight linear projections (thesis 4.3.1, table 4.2 with the flip 4.17).

#include "lib/octant.cl"
#include "shared/geometry.h"

/// Renders the scene into octahedral tiles.   thesis 4.3.1; 6.1.2 "depth textures"
/// launch : 1-D, eight work-items per tile, one per octant; their texels are disjoint, so no atomics are needed
/// in     : triangles[triangle_count], planes, cops[first_tile + tile] (xyz, scene units), n even
/// out    : hits, atlas layout, interior texels of tiles first_tile ..; disparity for a direction of unit L1 norm
/// needs  : nothing of the centres: a triangle whose plane passes within PLANE_TOLERANCE of one is not seen from it
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void rasterize_octahedral(global const Triangle *triangles, int triangle_count,
                                                                                global const float4 *planes, global const float4 *cops,
                                                                                int first_tile, int tile_count, int n, global Hit *hits) {
    int item = get_global_id(0);
    if (item >= OCTANTS * tile_count) return;
    Octant octant = octant_begin(item, cops, first_tile, n, hits);
    for (int i = 0; i < triangle_count; ++i) octant_draw(&octant, triangles, planes, i);
}
