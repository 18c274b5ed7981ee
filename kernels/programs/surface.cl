// The surface method. Kernels that are built together, since a program costs more than a kernel.

#include "place_surface_pencils.cl"
#include "trace_hemispheres.cl"
#include "measure_hemispheres.cl"
#include "emit_hemispheres.cl"
#include "sum_hemispheres.cl"
#include "project_surface_pencils.cl"
#include "link_surfels.cl"
#include "transport_irradiance.cl"
#include "close_series.cl"
#include "cover_film.cl"
#include "smooth_irradiance.cl"
#include "project_film_pencils.cl"
