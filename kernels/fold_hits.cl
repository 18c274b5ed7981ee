// Completes geometry maps: gutters of the hit atlas, and the atlas of plane indices that visibility tests read first.

/// Fills the gutter by folding and writes the plane of every texel.   thesis 4.3.1, last paragraph (replicated border texels)
/// launch : 1-D, one work-item per texel of `tile_count` tiles, gutters included
/// in     : triangles; hits, interior texels
/// out    : hits, gutter texels; plane_atlas, all texels, -1 where nothing is seen
kernel void fold_hits(global const Triangle *triangles, int first_tile, int tile_count, int n, global Hit *hits, global int *plane_atlas)
{
    int item = get_global_id(0);
    int texels = PENCIL_TILE_TEXELS(n);
    if (item >= tile_count * texels) return;
    int stride = PENCIL_TILE_STRIDE(n);
    int tile = first_tile + item / texels;
    int2 texel = (int2)(item % texels % stride, item % texels / stride) - PENCIL_GUTTER;
    int2 source = oct_fold_texel(texel, n);
    Hit hit = hits[oct_atlas_index(tile, source, n)];
    int target = oct_atlas_index(tile, texel, n);
    if (texel.x != source.x || texel.y != source.y) hits[target] = hit;
    plane_atlas[target] = hit.triangle < 0 ? -1 : triangles[hit.triangle].plane;
}
