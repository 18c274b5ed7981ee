// Launcher of kernels/cover_film.cl.
#pragma once

#include "device/features.h"
#include "surface/film_lattice.h"

namespace pencil {

/// Of the surfels whose byte in uncovered[capacity] is 1, leaves it where no pencil of the lattice points about the surfel's pixel has a
/// reuse_error of at most most_error, and clears it elsewhere.
void cover_film(Kernels& kernels, const FilmSurfels& film, const PencilLattice& lattice, float most_error,
                Buffer<unsigned char>& uncovered);

}  // namespace pencil
