#include "surface/cover_film.h"

namespace pencil {

void cover_film(Kernels& kernels, const FilmSurfels& film, const PencilLattice& lattice, float most_error,
                Buffer<unsigned char>& uncovered) {
    kernels.get("cover_film")
        .args(film.list(), lattice.pencils.data, lattice.levels(), most_error, film.extent(), uncovered)
        .run(film.pixels(), "cover film");
}

}  // namespace pencil
