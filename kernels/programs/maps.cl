// Geometry maps, and direct light through them or by rays. Kernels that are built together, since a program costs more than a kernel.

#include "rasterize_octahedral.cl"
#include "rasterize_clusters.cl"
#include "trace_octahedral.cl"
#include "fold_hits.cl"
#include "light_surfels.cl"
#include "sample_lights.cl"
