// Film pencils: surface pencils on a lattice of pixels, refined where their irradiance may not be reused, and the film lit by them.
#pragma once

#include "surface/film_lattice.h"
#include "surface/film_pixels.h"
#include "surface/surface_solver.h"

namespace pencil {

struct FilmLattice {
    int coarsest;      // spacing [pixels]; 0: no lattice, every surfel has a pencil of its own
    float most_error;  // reuse_error
    int map;           // width of the maps
    float smooth;      // reuse_error at which neighbours are not smoothed over
};

class FilmPencils {
public:
    /// `pixels` must outlive the pencils.
    FilmPencils(Kernels& kernels, const FilmPixels& pixels, const FilmLattice& lattice);

    /// Gathers, refines, gathers.
    void refine(SurfaceSolver& solver, const TexelPoints& points);

    int count() const { return pencils_.count + singles_.count; }
    /// Of all texels.
    double rays() const {
        return static_cast<double>(pencils_.count) * pencils_.texels() + static_cast<double>(singles_.count) * singles_.texels();
    }

    /// Adds reflected irradiance to the surfels of the film.
    void project(Buffer<float>& outgoing);

private:
    bool has_lattice() const { return lattice_.coarsest > 0; }
    void place_coarsest();
    void refine_lattice(SurfaceSolver& solver, const TexelPoints& points);
    void place(const std::vector<int>& pixels, int spacing);
    FilmSurfels film_surfels() const { return {film_.surfels(), film_.counts(), film_.first_surfel(), film_.width(), film_.height()}; }
    PencilLattice lattice(int finest) const { return {pencils_, pencil_at_, lattice_.coarsest, finest}; }
    std::vector<unsigned char> uncovered(int spacing);
    std::vector<int> finer_pixels(const std::vector<unsigned char>& uncovered, int spacing) const;
    void place_singles(const std::vector<unsigned char>& uncovered);

    Kernels& kernels_;
    const FilmPixels& pixels_;
    const Film& film_;
    FilmLattice lattice_;
    int finest_ = 1;         // spacing that refine() went down to
    std::vector<int> at_;    // pencil by pixel, -1: none
    Buffer<int> pencil_at_;  // the same on the device
    SurfacePencils pencils_;
    SurfacePencils singles_;  // of surfels that the finest lattice leaves uncovered
    Buffer<int> single_at_;   // by surfel, -1: none
    int gathered_ = 0;
};

}  // namespace pencil
