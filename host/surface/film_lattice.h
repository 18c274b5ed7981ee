// What the kernels of film pencils read: the film's surfels by pixel, and pencils on a lattice of pixels.
#pragma once

#include "device/surfels.h"
#include "surface/surface_pencils.h"

namespace pencil {

/// Surfels by pixel: those of pixel p are first[p] .. first[p] + (counts[p] & FILM_COUNT_MASK).
struct FilmSurfels {
    const Surfels& surfels;
    const Buffer<unsigned char>& counts;
    const Buffer<int>& first;
    int width, height;  // [pixels]

    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// Pencils on lattice points, whose coordinates are multiples of a spacing or the film's last row or column.
struct PencilLattice {
    const SurfacePencils& pencils;
    const Buffer<int>& at;  // pencil by pixel, -1: none
    int coarsest, finest;   // spacings, powers of two [pixels]
};

}  // namespace pencil
