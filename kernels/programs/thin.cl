// Views of fields: indirect light of some of the pixels. Kernels that are built together, since a program costs more than a kernel.

#include "pick_surfels.cl"
#include "spread_light.cl"
#include "thin_film.cl"
