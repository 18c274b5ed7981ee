// Visibility V(x, c) of thesis eq. (5.17) from the geometry map of c. No scene-dependent epsilon: the footprint agrees if it shows the
// plane of the surfel and nothing that could hide it (fold_hits.cl). Otherwise planes and, at silhouettes, the triangles that the
// footprint shows are tested against the segment from c to x exactly. Needs octahedral.cl, triangle.cl.

/// A geometry map and what it shows.
typedef struct VisibilityMap {
    global const int2 *cells;
    global const Hit *hits;
    global const Triangle *triangles;
    global const float4 *planes;
    int n;
} VisibilityMap;

/// Whether what texel `at` shows hides x: 0 no, 1 its plane speaks for it, 2 its triangle crosses the segment from cop to x.
inline int texel_hides(const VisibilityMap *map, int at, float4 cop, float4 x, float cop_ahead, float4 own_plane)
{
    Hit hit = map->hits[at];
    if (line_meets_triangle(map->triangles + hit.triangle, cop, x - cop, cop_ahead > 0.0f ? 1.0f : -1.0f)) return 2;
    int stride = PENCIL_TILE_STRIDE(map->n);
    int local_index = at % PENCIL_TILE_TEXELS(map->n);
    int2 texel = (int2)(local_index % stride, local_index / stride) - PENCIL_GUTTER;
    float4 seen = cop + oct_texel_direction(oct_fold_texel(texel, map->n), map->n) / hit.disparity;
    float own_side = plane_ahead(own_plane, cop) > 0.0f ? 1.0f : -1.0f;
    return plane_ahead(own_plane, seen) * own_side > PLANE_TOLERANCE ? 1 : 0;
}

/// The mixed footprint: `index` is the atlas index of its first texel, (fx, fy) its bilinear weights. Rules, in this order:
///   1. a triangle shown by the footprint that the segment crosses in front of x hides x;
///   2. a texel that shows the plane of x itself shows x;
///   3. otherwise a texel hides x if x is behind the plane it shows and what it shows is in front of the plane of x (which a neighbouring
///      facet of a smooth surface never is); x is hidden if texels of more than half the bilinear weight hide it.
inline bool mixed_footprint_visible(const VisibilityMap *map, int index, float fx, float fy, float4 cop, float4 x, int own)
{
    bool shown = false;
    float hidden = 0.0f;
    int stride = PENCIL_TILE_STRIDE(map->n);
    for (int k = 0; k < 4; ++k) {
        int at = index + (k & 1) + (k >> 1) * stride;
        int triangle = map->hits[at].triangle;
        if (triangle < 0) continue;
        int other = map->triangles[triangle].plane;
        shown |= other == own;
        if (other == own) continue;
        float4 plane = map->planes[other];
        float cop_ahead = plane_ahead(plane, cop);
        float x_ahead = plane_ahead(plane, x);
        if (cop_ahead * x_ahead >= 0.0f || fabs(x_ahead) < PLANE_TOLERANCE) continue;
        int hides = texel_hides(map, at, cop, x, cop_ahead, map->planes[own]);
        if (hides == 2) return false;
        if (hides == 1) hidden += (k & 1 ? fx : 1.0f - fx) * (k >> 1 ? fy : 1.0f - fy);
    }
    return shown || hidden <= 0.5f;
}
