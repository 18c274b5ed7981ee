// Completes geometry maps: gutters of the hit atlas, and for every 2x2 footprint what visibility tests need to know first.

/// Disparity of a whole plane along `direction`, whether it is what is seen there or not.
inline float plane_disparity(float4 plane, float4 cop, float4 direction)
{
    return dot(plane.xyz, direction.xyz) / plane_ahead(plane, cop);
}

/// True if, within a footprint that shows both, surfels on plane a can be hidden by plane b: where b is shown it is the nearer of the two.
/// Where b is shown although it is the farther (a convex edge, or the far side of a silhouette), nothing of a is there: it would be seen.
inline bool plane_hides(const int *shown, const float4 *planes, const float4 *directions, int a, int b, float4 cop)
{
    for (int k = 0; k < 4; ++k)
        if (shown[k] == shown[b] && plane_disparity(planes[b], cop, directions[k]) >= plane_disparity(planes[a], cop, directions[k])) return true;
    return false;
}

/// The cell of a footprint, see shared/atlas.h.
inline int2 footprint_cell(const int *shown, const float4 *planes, const float4 *directions, float4 cop)
{
    int a = 0, b = 0;
    for (int k = 1; k < 4; ++k)
        if (shown[k] != shown[a]) b = k;
    for (int k = 0; k < 4; ++k)
        if (shown[k] != shown[a] && shown[k] != shown[b]) return (int2)(CELL_MIXED);
    if (a == b || shown[a] < 0 || shown[b] < 0) return (int2)(shown[a], shown[b]);
    bool safe = !plane_hides(shown, planes, directions, a, b, cop) && !plane_hides(shown, planes, directions, b, a, cop);
    return (int2)(shown[a], safe ? shown[b] : CELL_PAIR(shown[b]));
}

/// Fills the gutter by folding and classifies footprints.   thesis 4.3.1, last paragraph (replicated border texels)
/// launch : 1-D, one work-item per texel of `tile_count` tiles, gutters included
/// in     : triangles, planes, cops; hits, interior texels
/// out    : hits, gutter texels; cells, for the footprint whose first texel this is
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
    int2 cell = footprint_cell(shown, plane, directions, cop);
    // A third plane next to a pair may reach in between the texels: the tip of a wall where it meets two others.
    if (cell.x != cell.y) {
        for (int k = 0; k < 16; ++k) {
            int2 next = oct_fold_texel(texel + (int2)(k % 4, k / 4) - 1, n);
            int triangle = hits[oct_atlas_index(tile, next, n)].triangle;
            int third = triangle < 0 ? -1 : triangles[triangle].plane;
            bool known = third == shown[0] || third == shown[1] || third == shown[2] || third == shown[3];
            if (!known) cell = (int2)(CELL_MIXED);
        }
    }
    cells[target] = cell;
}
