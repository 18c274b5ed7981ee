// Visibility V(x, c) of thesis eq. (5.17) from the geometry map of c. No scene-dependent epsilon: the footprint agrees if it shows the
// plane of the surfel and nothing that could hide it (fold_hits.cl). Otherwise planes and, at silhouettes, the triangles that the
// footprint shows are tested against the segment from c to x exactly. Needs octahedral.cl, triangle.cl.

/// A geometry map and what it shows.
typedef struct VisibilityMap {
    global const int2 *cells;
    global const int4 *corners;
    global const Hit *hits;
    global const Triangle *triangles;
    global const float4 *planes;
    int n;
} VisibilityMap;

/// True if the line from cop to x passes through triangle `index` or a mate of it in the same plane: a wall of two triangles may show one
/// and be crossed in the other.
inline bool line_meets_plane_part(const VisibilityMap *map, int index, float4 cop, float4 x, float side)
{
    global const Triangle *triangle = map->triangles + index;
    if (line_meets_triangle(triangle, cop, x - cop, side)) return true;
    int before = triangle->mates & 0xff, after = triangle->mates >> 8;
    for (int t = -before; t <= after; ++t)
        if (t != 0 && line_meets_triangle(triangle + t, cop, x - cop, side)) return true;
    return false;
}

/// True if what a texel shows, on plane `other`, is in front of the surfel's own plane as seen from cop.
inline bool shows_front_of(Hit hit, float4 direction, float4 cop, float4 own_plane)
{
    float own_side = plane_ahead(own_plane, cop) > 0.0f ? 1.0f : -1.0f;
    return plane_ahead(own_plane, cop + direction / hit.disparity) * own_side > PLANE_TOLERANCE;
}

/// The mixed footprint: `index` is the atlas index of its first texel, (fx, fy) its bilinear weights. Rules, in this order:
///   1. a triangle shown by the footprint or by a texel next to it, or a mate of that triangle, that the segment crosses in front of x
///      hides x;
///   2. a texel that shows the plane of x itself shows x;
///   3. otherwise a texel hides x if x is behind the plane it shows and what it shows is in front of the plane of x (which a neighbouring
///      facet of a smooth surface never is); x is hidden if texels of more than half the bilinear weight hide it.
inline bool mixed_footprint_visible(const VisibilityMap *map, int index, float fx, float fy, float4 cop, float4 x, int own)
{
    int n = map->n, stride = PENCIL_TILE_STRIDE(n), tile = index / PENCIL_TILE_TEXELS(n);
    int2 corner = (int2)(index % PENCIL_TILE_TEXELS(n) % stride, index % PENCIL_TILE_TEXELS(n) / stride) - PENCIL_GUTTER;
    bool inside = corner.x >= 1 && corner.y >= 1 && corner.x < n - 2 && corner.y < n - 2;  // no texel needs folding
    bool shown = false;
    float hidden = 0.0f;
    int last = -1;
    for (int k = 0; k < 16; ++k) {
        int2 offset = (int2)(k % 4, k / 4) - 1;
        bool inner = offset.x >= 0 && offset.x <= 1 && offset.y >= 0 && offset.y <= 1;
        int2 texel = inside ? corner + offset : oct_fold_texel(corner + offset, n);
        Hit hit = map->hits[oct_atlas_index(tile, texel, n)];
        if (hit.triangle < 0 || (hit.triangle == last && !inner)) continue;
        int other = map->triangles[hit.triangle].plane;
        shown |= inner && other == own;
        if (other == own) continue;
        float4 plane = map->planes[other];
        float cop_ahead = plane_ahead(plane, cop);
        float x_ahead = plane_ahead(plane, x);
        if (cop_ahead * x_ahead >= 0.0f || fabs(x_ahead) < PLANE_TOLERANCE) continue;
        if (hit.triangle != last && line_meets_plane_part(map, hit.triangle, cop, x, cop_ahead > 0.0f ? 1.0f : -1.0f)) return false;
        last = hit.triangle;
        if (inner && shows_front_of(hit, oct_texel_direction(texel, n), cop, map->planes[own]))
            hidden += (offset.x ? fx : 1.0f - fx) * (offset.y ? fy : 1.0f - fy);
    }
    return shown || hidden <= 0.5f;
}

/// True if x is not behind any of four planes other than its own.
inline bool ahead_of_corner(const VisibilityMap *map, int4 corner, float4 cop, float4 x, int own)
{
    int planes[4];
    vstore4(corner, 0, planes);
    for (int k = 0; k < 4; ++k) {
        if (planes[k] == own) continue;
        float4 plane = map->planes[planes[k]];
        float x_ahead = plane_ahead(plane, x);
        if (plane_ahead(plane, cop) * x_ahead < 0.0f && fabs(x_ahead) >= PLANE_TOLERANCE) return false;
    }
    return true;
}

/// A mixed cell in front of all that it and its neighbourhood show is seen; the others are looked at texel by texel.
inline bool mixed_cell_visible(const VisibilityMap *map, int index, float fx, float fy, float4 cop, float4 x, int own)
{
    int4 corner = map->corners[index];
    if (corner.x >= 0 && ahead_of_corner(map, corner, cop, x, own)) return true;
    return mixed_footprint_visible(map, index, fx, fy, cop, x, own);
}
