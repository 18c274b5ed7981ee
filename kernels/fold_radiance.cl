// Completes radiance maps: gutters by folding, so that bilinear look-ups are seamless.

/// launch : 1-D, one work-item per gutter texel: 4 (n + 1) per tile
/// in/out : radiance, atlas layout; gutter texels become copies of the interior texels they fold to
kernel void fold_radiance(int first_tile, int tile_count, int n, global float4 *radiance)
{
    int item = get_global_id(0);
    int around = 4 * (n + 1);
    if (item >= tile_count * around) return;
    int tile = first_tile + item / around;
    int side = item % around / (n + 1);
    int along = item % (n + 1);
    // Each side owns its first corner: together they run round the tile.
    int2 texel = side == 0 ? (int2)(along - 1, -1) : side == 1 ? (int2)(n, along - 1) : side == 2 ? (int2)(n - along, n) : (int2)(-1, n - along);
    radiance[oct_atlas_index(tile, texel, n)] = radiance[oct_atlas_index(tile, oct_fold_texel(texel, n), n)];
}
