// What depends on materials and lights: every render. Kernels that are built together, since a program costs more than a kernel.

#include "film_surfels.cl"
#include "light_surfels.cl"
#include "sample_lights.cl"
#include "trace_checks.cl"
#include "trace_hemispheres.cl"
