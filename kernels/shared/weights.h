// Forms of the quadrature weights of pencils, the values of the define PENCIL_WEIGHTS.
#pragma once

#define PENCIL_WEIGHTS_DPDF 0      // directional pencil density, thesis eq. (5.32), self-normalised
#define PENCIL_WEIGHTS_VORONOI 1   // cosine-weighted solid angles of the Voronoi cells of directions
#define PENCIL_WEIGHTS_ANALYTIC 2  // density from the free path, self-normalised
#define PENCIL_WEIGHTS_THESIS 3    // directional pencil density with the printed normaliser, eq. (5.33)
#define PENCIL_WEIGHTS_POWER 4     // power cells of the directions of pencils and of rays that the surfels send themselves

// Numbers of a ray of a surfel, [ray][field][surfel]: its direction in the frame of the surfel's cells by the tangents, how far its cell
// reaches (cell_radius; -1: there is no ray), and the light that it found [W m^-2 sr^-1].
#define RAY_TANGENT 0
#define RAY_BITANGENT 1
#define RAY_RADIUS 2
#define RAY_R 3
#define RAY_G 4
#define RAY_B 5
#define RAY_FIELDS 6

// Cells, Voronoi's or of a power diagram, are sampled by tiles of so many directions.
#define PENCIL_CELL_TILE 16
// So many directions a site, up to the square of this grid.
#define PENCIL_CELL_DIRECTIONS 4
#define PENCIL_CELL_LARGEST_GRID 48
