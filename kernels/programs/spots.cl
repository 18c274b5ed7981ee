// Rays towards bright spots. Kernels that are built together, since a program costs more than a kernel.

#include "guide_hemispheres.cl"
#include "share_hemispheres.cl"
#include "sum_guides.cl"
