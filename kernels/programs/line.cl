// Line projection. Kernels that are built together, since a program costs more than a kernel.

#include "find_enclosing.cl"
#include "find_sides.cl"
#include "gather_surfels.cl"
#include "test_visibility.cl"
#include "estimate_density.cl"
#include "free_path_density.cl"
#include "project_pencils.cl"
#include "store_radiance.cl"
#include "smooth_radiance.cl"
#include "sum_radiance.cl"
