// Completes geometry maps: gutters of the hit atlas, and for every 2x2 footprint what visibility tests need to know first.

/// Disparity of a whole plane along `direction`, whether it is what is seen there or not.
inline float plane_disparity(float4 plane, float4 cop, float4 direction)
{
    return dot(plane.xyz, direction.xyz) / plane_ahead(plane, cop);
}

/// True if, within a footprint that shows both, plane b can hide surfels of plane a: it is the nearer where it is shown, and they do not
/// meet in the footprint. They meet if each is shown where it is the nearer (a concave joint) or each where it is the farther (a convex
/// edge); at a silhouette the nearer is shown where it is nearer, the other where it is farther.
inline bool plane_hides(const int *shown, const float4 *planes, const float4 *directions, int a, int b, float4 cop)
{
    bool b_nearer_at_b = true, b_nearer_at_a = true;
    for (int k = 0; k < 4; ++k) {
        if (shown[k] != shown[a] && shown[k] != shown[b]) continue;
        bool b_nearer = plane_disparity(planes[b], cop, directions[k]) > plane_disparity(planes[a], cop, directions[k]);
        if (shown[k] == shown[b]) b_nearer_at_b = b_nearer_at_b && b_nearer;
        else b_nearer_at_a = b_nearer_at_a && b_nearer;
    }
    return b_nearer_at_b && b_nearer_at_a;
}

/// Fills the gutter by folding and classifies footprints.   thesis 4.3.1, last paragraph (replicated border texels)
/// launch : 1-D, one work-item per texel of `tile_count` tiles, gutters included
/// in     : triangles, planes, cops; hits, interior texels
/// out    : hits, gutter texels; cells, for the footprint whose first texel this is: (a, a) if plane a fills it (-1: nothing seen),
///          otherwise up to two planes whose surfels nothing else in the footprint can hide, CELL_MIXED in the places left
kernel void fold_hits(global const Triangle *triangles, global const float4 *planes, global const float4 *cops, int first_tile,
                      int tile_count, int n, global Hit *hits, global int2 *cells)
{
    int item = get_global_id(0);
    int texels = PENCIL_TILE_TEXELS(n);
    if (item >= tile_count * texels) return;
    int stride = PENCIL_TILE_STRIDE(n);
    int tile = first_tile + item / texels;
    int2 texel = (int2)(item % texels % stride, item % texels / stride) - PENCIL_GUTTER;
    int2 source = oct_fold_texel(texel, n);
    int target = oct_atlas_index(tile, texel, n);
    if (texel.x != source.x || texel.y != source.y) hits[target] = hits[oct_atlas_index(tile, source, n)];
    if (texel.x >= n || texel.y >= n) return;  // no footprint starts in the last gutter column or row

    float4 cop = (float4)(cops[tile].xyz, 0.0f);
    int shown[4];
    float4 directions[4], plane[4];
    for (int k = 0; k < 4; ++k) {
        int2 corner = oct_fold_texel(texel + (int2)(k & 1, k >> 1), n);
        int triangle = hits[oct_atlas_index(tile, corner, n)].triangle;
        shown[k] = triangle < 0 ? -1 : triangles[triangle].plane;
        plane[k] = planes[max(shown[k], 0)];
        directions[k] = oct_texel_direction(corner, n);
    }
    if (shown[0] == shown[1] && shown[0] == shown[2] && shown[0] == shown[3]) {
        cells[target] = (int2)(shown[0]);
        return;
    }
    int safe[2] = {CELL_MIXED, CELL_MIXED};
    int found = 0;
    for (int a = 0; a < 4; ++a) {
        bool hidden = false;
        for (int b = 0; b < 4; ++b)
            hidden = hidden || (shown[a] >= 0 && shown[b] >= 0 && shown[a] != shown[b] && plane_hides(shown, plane, directions, a, b, cop));
        if (!hidden && found < 2 && shown[a] != safe[0]) safe[found++] = shown[a];
    }
    cells[target] = (int2)(safe[0], safe[1]);
}
