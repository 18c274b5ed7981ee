// What project_pencils adds: the form of quadrature weights that the render has. The other form is not compiled.

#include "lib/projection.cl"
#include "lib/footprint.cl"
#include "shared/weights.h"

#if PENCIL_WEIGHTS == PENCIL_WEIGHTS_VORONOI
#include "lib/weights_voronoi.cl"
#else
#include "lib/weights_density.cl"
#endif
