// Octahedral tiles lie one after the other in one buffer. A tile of SIZE x SIZE texels is stored with a gutter of one texel on every side,
// filled by folding, so that bilinear look-ups never leave it:
//   texel (x, y) of tile t, 0 <= x, y < SIZE  ->  t * STRIDE^2 + (y + 1) * STRIDE + (x + 1),   STRIDE = SIZE + 2
#ifndef PENCIL_SHARED_ATLAS_H
#define PENCIL_SHARED_ATLAS_H

#define PENCIL_GUTTER 1
#define PENCIL_TILE_STRIDE(size) ((size) + 2 * PENCIL_GUTTER)
#define PENCIL_TILE_TEXELS(size) (PENCIL_TILE_STRIDE(size) * PENCIL_TILE_STRIDE(size))


// In the cell of a footprint: no plane whose surfels are seen for sure (fold_hits.cl).
#define CELL_MIXED (-2)

#endif
