// Direct light, through geometry maps or by rays. Kernels that are built together, since a program costs more than a kernel.

#include "light_surfels.cl"
#include "sample_lights.cl"
