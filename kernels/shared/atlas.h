// The maps of pencils, tiles, lie one after the other in one buffer. An octahedral tile of SIZE x SIZE texels is stored with a gutter of one
// texel on every side, filled by folding, so that bilinear look-ups never leave it:
//   texel (x, y) of tile t, 0 <= x, y < SIZE  ->  t * STRIDE^2 + (y + 1) * STRIDE + (x + 1),   STRIDE = SIZE + 2
// Tiles of other kinds (shared/map_kind.h) are columns of PANELS such squares, each with its gutter:
//   texel (x, y) of panel p  =  texel (x, p * STRIDE + y) of tile t  ->  t * PANELS * STRIDE^2 + (p * STRIDE + y + 1) * STRIDE + (x + 1)
#pragma once

#define PENCIL_GUTTER 1
#define PENCIL_TILE_STRIDE(size) ((size) + 2 * PENCIL_GUTTER)
#define PENCIL_TILE_TEXELS(size) (PENCIL_TILE_STRIDE(size) * PENCIL_TILE_STRIDE(size))  // of one square

// Cells: what a 2x2 footprint tells of the visibility of surfels seen through it.
//   (a, a)              plane a fills it; -1: it shows nothing
//   (a, b)              it shows a and b, and surfels on either are seen: they meet at a convex edge, or b is -1
//   (a, CELL_PAIR(b))   it shows a and b; a surfel on one of them is seen if it is not behind the other
//   (CELL_MIXED, same)  three planes or more; or two walls that meet, with a third next to them that reaches in between the texels
#define CELL_MIXED (-2)
#define MOST_GROUPS 4           // of triangles about a footprint that are stored: an int4
#define GROUP_INNER 0x40000000  // of a group of triangles about a footprint: a texel of the footprint itself shows it
#define GROUP_TRIANGLE(group) ((group) < 0 ? (group) : (group) & ~GROUP_INNER)
#define CELL_PAIR(plane) (-3 - (plane))  // its own inverse
