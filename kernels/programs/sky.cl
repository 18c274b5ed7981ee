// The environment behind the film.

#include "show_sky.cl"
