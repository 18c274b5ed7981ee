// What project_pencils adds: the form of quadrature weights that the render has. The other form is not compiled.

#include "lib/cells.cl"
#include "lib/far_end.cl"
#include "lib/footprint.cl"
#include "lib/map.cl"
#include "lib/projection.cl"
#include "lib/surfel_rays.cl"
#include "shared/weights.h"

#if PENCIL_CELL_GRID > 0
#include "lib/weights_cells.cl"
#else
#include "lib/weights_density.cl"
#endif
