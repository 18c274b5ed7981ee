// Visibility V(x, c) of thesis eq. (5.17) from the geometry map of c. No scene-dependent epsilon: a texel agrees if it shows the plane
// of the surfel; where the 2x2 footprint is mixed, the triangles it shows are tested against the segment from c to x exactly, and the
// rest is decided by planes. Needs octahedral.cl, triangle.cl.

/// A geometry map and what it shows.
typedef struct VisibilityMap {
    global const int *plane_atlas;
    global const Hit *hits;
    global const Triangle *triangles;
    global const float4 *planes;
    int n;
} VisibilityMap;

/// The mixed footprint: `index` is the atlas index of its first texel, (fx, fy) its bilinear weights. Rules, in this order:
///   1. a triangle shown by the footprint that the segment crosses in front of x hides x;
///   2. a texel that shows the plane of x itself shows x;
///   3. otherwise a texel hides x if x is behind the plane it shows and what it shows is in front of the plane of x (which a neighbouring
///      facet of a smooth surface never is); x is hidden if texels of more than half the bilinear weight hide it.
inline bool mixed_footprint_visible(const VisibilityMap *map, int index, float fx, float fy, float4 cop, float4 x, float4 own_plane, int own)
{
    bool shown = false;
    float hidden = 0.0f;
    int stride = PENCIL_TILE_STRIDE(map->n);
    float4 direction = x - cop;
    float own_side = plane_ahead(own_plane, cop) > 0.0f ? 1.0f : -1.0f;
    for (int k = 0; k < 4; ++k) {
        int at = index + (k & 1) + (k >> 1) * stride;
        Hit hit = map->hits[at];
        if (hit.triangle < 0) continue;
        global const Triangle *triangle = map->triangles + hit.triangle;
        if (triangle->plane == own) {
            shown = true;
            continue;
        }
        float4 plane = map->planes[triangle->plane];
        float cop_ahead = plane_ahead(plane, cop);
        float x_ahead = plane_ahead(plane, x);
        if (cop_ahead * x_ahead >= 0.0f || fabs(x_ahead) < PLANE_TOLERANCE) continue;
        if (line_meets_triangle(triangle, cop, direction, cop_ahead > 0.0f ? 1.0f : -1.0f)) return false;
        int local_index = at % PENCIL_TILE_TEXELS(map->n);
        int2 texel = (int2)(local_index % stride, local_index / stride) - PENCIL_GUTTER;
        float4 seen = cop + oct_texel_direction(oct_fold_texel(texel, map->n), map->n) / hit.disparity;
        if (plane_ahead(own_plane, seen) * own_side > PLANE_TOLERANCE) hidden += (k & 1 ? fx : 1.0f - fx) * (k >> 1 ? fy : 1.0f - fy);
    }
    return shown || hidden <= 0.5f;
}

/// Visibility of surfel position x on plane `own` from `cop`.
inline bool footprint_visible(const VisibilityMap *map, int index, float fx, float fy, float4 cop, float4 x, int own)
{
    global const int *p = map->plane_atlas + index;
    int4 shown = (int4)(vload2(0, p), vload2(0, p + PENCIL_TILE_STRIDE(map->n)));
    if (all(shown == (int4)(own))) return true;
    return mixed_footprint_visible(map, index, fx, fy, cop, x, map->planes[own], own);
}
