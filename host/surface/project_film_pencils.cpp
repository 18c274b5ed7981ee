#include "surface/project_film_pencils.h"

namespace pencil {

void project_film_pencils(Kernels& kernels, const FilmSurfels& film, const PencilLattice& lattice, const Buffer<float4>& fits,
                          float most_error, const SinglePencils& singles, Buffer<float>& outgoing) {
    kernels.get("project_film_pencils")
        .args(film.surfels.data, film.surfels.capacity, film.counts, film.first, lattice.pencils.data, fits, lattice.at, lattice.coarsest,
              lattice.finest, most_error, singles.pencils.irradiance, singles.at, film.width, film.height, outgoing)
        .run(film.pixels(), "project film pencils");
}

}  // namespace pencil
