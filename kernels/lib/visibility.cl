// Visibility V(x, c) of thesis eq. (5.17) from the geometry map of c. No scene-dependent epsilon: the footprint agrees if it shows the
// plane of the surfel and nothing that could hide it (fold_hits.cl). Otherwise planes and, at silhouettes, the triangles that the
// footprint shows are tested against the segment from c to x exactly. Rules for a footprint that its
// cell does not settle, in this order:
//   1. a triangle shown by the footprint or by a texel next to it, or a mate of that triangle in the same plane, that the segment crosses
//      in front of x hides x: a wall of two triangles may show one and be crossed in the other;
//   2. a texel that shows the plane of x itself shows x;
//   3. otherwise x is hidden if texels of more than half the bilinear weight hide it (hiding_weight).

#include "lib/map.cl"
#include "lib/surfaces.cl"
#include "lib/triangle.cl"
#include "shared/bvh.h"
#include "shared/geometry.h"

/// A geometry map and what it shows.
typedef struct VisibilityMap {
    global const int2 *cells;
    global const int4 *groups;
    global const Hit *hits;
    global const Triangle *triangles;
    global const float4 *planes;
    int n;
    global const HierarchyNode *nodes;  // with PENCIL_BVH, and then only these and the scene
    global const HierarchyLeaf *leaves;
    const Surfaces *scene;
} VisibilityMap;

/// True if the segment from cop to x crosses triangle `index` or one of its mates in front of x.
static inline bool segment_crosses(const VisibilityMap *map, int index, float4 cop, float4 x) {
    global const Triangle *triangle = map->triangles + index;
    float4 plane = map->planes[triangle->plane];
    float cop_ahead = plane_ahead(plane, cop);
    float x_ahead = plane_ahead(plane, x);
    if (cop_ahead * x_ahead >= 0.0f || fabs(x_ahead) < PLANE_TOLERANCE) return false;
#pragma unroll 1
    for (int t = -MATES_BEFORE(triangle->mates); t <= MATES_AFTER(triangle->mates); ++t)
        if (line_meets_triangle(triangle + t, cop, x - cop, cop_ahead > 0.0f ? 1.0f : -1.0f)) return true;
    return false;
}

/// Bilinear weight of the texels of a footprint that hide x although no triangle they show is crossed: x is behind the plane they show, and
/// what they show is in front of the plane of x, which a neighbouring facet of a smooth surface never is.
static inline float hiding_weight(const VisibilityMap *map, int tile, int2 corner, float fx, float fy, float4 cop, float4 x, int own) {
    float4 own_plane = map->planes[own];
    float own_side = plane_ahead(own_plane, cop) > 0.0f ? 1.0f : -1.0f;
    float hidden = 0.0f;
    for (int k = 0; k < 4; ++k) {
        int2 texel = map_footprint_texel(corner, k, map->n);
        Hit hit = map->hits[map_atlas_index(tile, texel, map->n)];
        if (hit.triangle < 0) continue;
        float4 plane = map->planes[map->triangles[hit.triangle].plane];
        float x_ahead = plane_ahead(plane, x);
        if (plane_ahead(plane, cop) * x_ahead >= 0.0f || fabs(x_ahead) < PLANE_TOLERANCE) continue;
        float4 seen = cop + map_texel_direction(texel, map->n) / hit.disparity;
        if (plane_ahead(own_plane, seen) * own_side > PLANE_TOLERANCE) hidden += (k & 1 ? fx : 1.0f - fx) * (k >> 1 ? fy : 1.0f - fy);
    }
    return hidden;
}

/// Rules 1 to 3 by the texels themselves, for a footprint with more groups of triangles about it than are stored. `corner` is its first
/// texel (-1: gutter) in `tile`, (fx, fy) its bilinear weights.
static inline bool crowded_footprint_visible(const VisibilityMap *map, int tile, int2 corner, float fx, float fy, float4 cop, float4 x,
                                             int own) {
    bool shown = false;
    for (int k = 0; k < AROUND_TEXELS; ++k) {
        int2 texel = map_texel_around(corner, k, map->n);
        int triangle = map->hits[map_atlas_index(tile, texel, map->n)].triangle;
        if (triangle < 0) continue;
        if (map->triangles[triangle].plane == own)
            shown = shown || texel_is_inner(k);
        else if (segment_crosses(map, triangle, cop, x))
            return false;
    }
    return shown || hiding_weight(map, tile, corner, fx, fy, cop, x, own) <= 0.5f;
}
