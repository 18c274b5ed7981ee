// Geometry maps as rasterize_octahedral.cl makes them, leaving out clusters of triangles that cannot change the octant.

#include "lib/octahedral.cl"
#include "lib/octant.cl"
#include "lib/raster.cl"
#include "shared/cluster.h"
#include "shared/geometry.h"

/// Relative slack of a cluster's disparity: its triangles' disparities are rounded.
#define DISPARITY_SLACK 1e-5f

/// True if a texel of rings ku, kv (ranges) of the octant shows nothing nearer than `disparity`.
static inline bool octant_shows(const Octant *o, int2 ku, int2 kv, float disparity) {
    int half_n = o->n / 2;
    for (int k = kv.x; k <= kv.y; ++k) {
        int k0 = o->s.z > 0.0f ? ku.x : max(ku.x, half_n - k);
        int k1 = o->s.z > 0.0f ? min(ku.y, half_n - 1 - k) : ku.y;
        int y = o->s.y > 0.0f ? half_n + k : half_n - 1 - k;
        int first = o->s.x > 0.0f ? half_n + k0 : half_n - 1 - k1;
        global const Hit *row = o->tile + oct_atlas_index(0, (int2)(first, y), o->n);
        for (int x = 0; x <= k1 - k0; ++x)
            if (row[x].disparity <= disparity) return true;
    }
    return false;
}

/// False if the part of the box in the octant holds no texel's centre, or lies behind all that those texels show.
static inline bool cluster_matters(const Octant *o, global const Cluster *cluster) {
    float4 s = (float4)(o->s, 0.0f);
    float4 a = (cluster->low - o->cop) * s, b = (cluster->high - o->cop) * s;
    float4 high = fmax(a, b);
    if (high.x < 0.0f || high.y < 0.0f || high.z < 0.0f) return false;
    float4 low = fmax(fmin(a, b), 0.0f);
    float distance = low.x + low.y + low.z;
    if (distance < BOX_TRUSTED_DISTANCE) return true;
    // |x| / W grows with |x| and falls with |y| and |z|: its bounds over a box are at corners.
    float4 uv = (float4)(low.x / (low.x + high.y + high.z), low.y / (high.x + low.y + high.z), high.x / (high.x + low.y + low.z),
                         high.y / (low.x + high.y + low.z));
    if (o->s.z < 0.0f) uv = 1.0f - uv.wzyx;
    int half_n = o->n / 2;
    int2 ku = raster_range(uv.x * half_n, uv.z * half_n, BOX_SLACK, half_n - 1);
    int2 kv = raster_range(uv.y * half_n, uv.w * half_n, BOX_SLACK, half_n - 1);
    return octant_shows(o, ku, kv, (1.0f + DISPARITY_SLACK) / distance);
}

/// Renders the scene into octahedral tiles.
/// launch : 1-D, eight work-items per tile, one per octant
/// in     : as rasterize_octahedral; clusters[cluster_count] of members[triangle_count] (pencils/cluster_triangles.h)
/// out    : as rasterize_octahedral
/// needs  : as rasterize_octahedral
kernel __attribute__((reqd_work_group_size(1, 1, 1))) void rasterize_clusters(global const Triangle *triangles, int triangle_count,
                                                                              global const float4 *planes, global const Cluster *clusters,
                                                                              int cluster_count, global const int *members,
                                                                              global const float4 *cops, int first_tile, int tile_count,
                                                                              int n, global Hit *hits) {
    int item = get_global_id(0);
    if (item >= OCTANTS * tile_count) return;
    Octant octant = clear_octant_of(item, cops, first_tile, n, hits);
    global const Cluster *groups = clusters + cluster_count;
    for (int g = 0; g * CLUSTER_GROUP < cluster_count; ++g) {
        if (!cluster_matters(&octant, groups + g)) continue;
        int last = min((g + 1) * CLUSTER_GROUP, cluster_count);
        for (int c = g * CLUSTER_GROUP; c < last; ++c) {
            if (!cluster_matters(&octant, clusters + c)) continue;
            int end = min((c + 1) * CLUSTER_TRIANGLES, triangle_count);
            for (int m = c * CLUSTER_TRIANGLES; m < end; ++m) draw_triangle(&octant, triangles, planes, members[m]);
        }
    }
}
