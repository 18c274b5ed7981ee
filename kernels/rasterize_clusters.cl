// Geometry maps as rasterize_octahedral.cl makes them, and the same of other kinds by their linear projections (thesis 4.3.1, tables 4.1 and
// 4.2), leaving out clusters of triangles that cannot change the facet.

#include "lib/facet.cl"
#include "shared/cluster.h"
#include "shared/geometry.h"

#if MAP_FACETS > 0

/// Renders the scene into tiles.
/// launch : 1-D, PENCIL_MAP_FACETS work-items per tile, one per facet
/// in     : as rasterize_octahedral; clusters[cluster_count] of members[triangle_count] (pencils/cluster_triangles.h)
/// out    : as trace_maps
/// needs  : as rasterize_octahedral
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void rasterize_clusters(global const Triangle *triangles, int triangle_count,
                                                                              global const float4 *planes, global const Cluster *clusters,
                                                                              int cluster_count, global const int *members,
                                                                              global const float4 *cops, int first_tile, int tile_count,
                                                                              int n, global Hit *hits) {
    int item = get_global_id(0);
    if (item >= MAP_FACETS * tile_count) return;
    Facet facet = facet_begin(item, cops, first_tile, n, hits);
    global const Cluster *groups = clusters + cluster_count;
    for (int g = 0; g * CLUSTER_GROUP < cluster_count; ++g) {
        if (!facet_matters(&facet, groups + g)) continue;
        int last = min((g + 1) * CLUSTER_GROUP, cluster_count);
        for (int c = g * CLUSTER_GROUP; c < last; ++c) {
            if (!facet_matters(&facet, clusters + c)) continue;
            int end = min((c + 1) * CLUSTER_TRIANGLES, triangle_count);
            for (int m = c * CLUSTER_TRIANGLES; m < end; ++m) facet_draw(&facet, triangles, planes, members[m]);
        }
    }
}

#endif
