// Forms of the quadrature weights of pencils, the values of the define PENCIL_WEIGHTS.
#pragma once

#define PENCIL_WEIGHTS_DPDF 0      // directional pencil density, thesis eq. (5.32), self-normalised
#define PENCIL_WEIGHTS_VORONOI 1   // cosine-weighted solid angles of the Voronoi cells of directions
#define PENCIL_WEIGHTS_ANALYTIC 2  // density from the free path, self-normalised
#define PENCIL_WEIGHTS_THESIS 3    // directional pencil density with the printed normaliser, eq. (5.33)

// Voronoi cells are sampled by tiles of so many directions.
#define PENCIL_CELL_TILE 16
