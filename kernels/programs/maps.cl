// Geometry maps. Kernels that are built together, since a program costs more than a kernel.

#include "fold_hits.cl"
#include "rasterize_clusters.cl"
#include "rasterize_octahedral.cl"
#include "trace_maps.cl"
