// Kinds of maps of pencils, the values of the define PENCIL_MAP_KIND (thesis 4.3).
#pragma once

#define PENCIL_MAP_OCTAHEDRAL 0  // one square, eight linear projections
#define PENCIL_MAP_PYRAMID 1     // two squares, a hemisphere each, four linear projections in each
#define PENCIL_MAP_CUBE 2        // six squares, a linear projection each
#define PENCIL_MAP_PARABOLOID 3  // two squares, a hemisphere in the circle of each; not linear

/// Squares of a map. They lie one below the other in its tile (shared/atlas.h).
#define PENCIL_MAP_PANELS(kind) ((kind) == PENCIL_MAP_OCTAHEDRAL ? 1 : (kind) == PENCIL_MAP_CUBE ? 6 : 2)

/// Its facets: parts in which directions are affine in texel coordinates, so that triangles can be drawn into them.
#define PENCIL_MAP_FACETS(kind) ((kind) == PENCIL_MAP_PARABOLOID ? 0 : (kind) == PENCIL_MAP_CUBE ? 6 : 8)
