// Launcher of kernels/cover_film.cl.
#pragma once

#include "device/features.h"
#include "surface/film_lattice.h"

namespace pencil {

/// uncovered[capacity]: 1 for surfels where no pencil of the lattice points about their pixel has a reuse_error of at most most_error, 0 for
/// the others.
void cover_film(Kernels& kernels, const FilmSurfels& film, const PencilLattice& lattice, float most_error,
                Buffer<unsigned char>& uncovered);

}  // namespace pencil
