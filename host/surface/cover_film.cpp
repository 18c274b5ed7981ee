#include "surface/cover_film.h"

namespace pencil {

void cover_film(Kernels& kernels, const FilmSurfels& film, const PencilLattice& lattice, float most_error,
                Buffer<unsigned char>& uncovered) {
    kernels.get("cover_film")
        .args(film.surfels.data, film.surfels.capacity, film.counts, film.first, lattice.pencils.data, lattice.at, lattice.coarsest,
              lattice.finest, most_error, film.width, film.height, uncovered)
        .run(film.pixels(), "cover film");
}

}  // namespace pencil
