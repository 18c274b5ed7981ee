// Lobes: mirrors, glass and gloss. Kernels that are built together, since a program costs more than a kernel.

#include "add_reflections.cl"
#include "emit_chains.cl"
#include "follow_surfels.cl"
#include "light_lobes.cl"
