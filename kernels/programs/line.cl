// Line projection. Kernels that are built together, since a program costs more than a kernel.

#include "estimate_density.cl"
#include "find_enclosing.cl"
#include "find_sides.cl"
#include "free_path_density.cl"
#include "gather_surfels.cl"
#include "project_pencils.cl"
#include "project_rays.cl"
#include "smooth_radiance.cl"
#include "store_radiance.cl"
#include "sum_radiance.cl"
#include "sum_rays.cl"
#include "test_visibility.cl"
