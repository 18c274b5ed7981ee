// Launcher of kernels/project_film_pencils.cl.
#pragma once

#include <tuple>

#include "device/features.h"
#include "surface/film_lattice.h"

namespace pencil {

/// Pencils that stand for one surfel each.
struct SinglePencils {
    /// Arguments `single_irradiance, single_at` of kernels.
    auto list() const { return std::tie(pencils.irradiance, at); }

    const SurfacePencils& pencils;
    const Buffer<int>& at;  // by surfel, -1: none
};

/// Adds albedo / pi times irradiance to outgoing[3][capacity] [W m^-2 sr^-1] of the film's surfels: that of a single pencil, or the
/// weighted mean of what the fits (smooth_irradiance) of the lattice points about the pixel say; their weight falls to 0 at most_error.
void project_film_pencils(Kernels& kernels, const FilmSurfels& film, const PencilLattice& lattice, const Buffer<float4>& fits,
                          float most_error, const SinglePencils& singles, Buffer<float>& outgoing);

}  // namespace pencil
