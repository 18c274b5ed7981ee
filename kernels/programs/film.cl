// The film: every render. Kernels that are built together, since a program costs more than a kernel.

#include "bound_film.cl"
#include "classify_film.cl"
#include "emit_surfels.cl"
#include "rasterize_film.cl"
#include "resolve_film.cl"
#include "whole_pixels.cl"
