// The surface method. Kernels that are built together, since a program costs more than a kernel.

#include "close_series.cl"
#include "cover_film.cl"
#include "emit_hemispheres.cl"
#include "link_surfels.cl"
#include "measure_hemispheres.cl"
#include "place_surface_pencils.cl"
#include "project_film_pencils.cl"
#include "project_surface_pencils.cl"
#include "smooth_irradiance.cl"
#include "sum_hemispheres.cl"
#include "trace_hemispheres.cl"
#include "transport_irradiance.cl"
