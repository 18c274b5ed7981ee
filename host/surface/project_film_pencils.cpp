#include "surface/project_film_pencils.h"

namespace pencil {

void project_film_pencils(Kernels& kernels, const FilmSurfels& film, const PencilLattice& lattice, const Buffer<float4>& fits,
                          float most_error, const SinglePencils& singles, Buffer<float>& outgoing) {
    kernels.get("project_film_pencils")
        .args(film.list(), lattice.pencils.data, fits, lattice.levels(), most_error, singles.list(), film.extent(), outgoing)
        .run(film.pixels(), "project film pencils");
}

}  // namespace pencil
