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

    /// Arguments of kernels: `surfels, capacity, counts, first_surfel`; `width, height`.
    auto list() const { return std::tuple_cat(surfels.store(), std::tie(counts, first)); }
    auto extent() const { return std::tie(width, height); }
    std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// Pencils on lattice points, whose coordinates are multiples of a spacing or the film's last row or column.
struct PencilLattice {
    /// Arguments `pencil_at, coarsest, finest` of kernels.
    auto levels() const { return std::tie(at, coarsest, finest); }

    const SurfacePencils& pencils;
    const Buffer<int>& at;  // pencil by pixel, -1: none
    int coarsest, finest;   // spacings, powers of two [pixels]
};

}  // namespace pencil
