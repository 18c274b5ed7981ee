// Film pencils: surface pencils on a lattice of pixels, refined where their irradiance may not be reused, and the film lit by them.
#pragma once

#include "film/film.h"
#include "surface/surface_solver.h"

namespace pencil {

struct FilmLattice {
    int coarsest;      // spacing [pixels]
    float most_error;  // reuse_error
    int map;           // width of the maps
    float smooth;      // reuse_error at which neighbours are not smoothed over
};

/// A pencil for each cell of spacing x spacing pixels that shows something, on the first of its surfels, with maps of map x map texels.
SurfacePencils seed_pencils(Kernels& kernels, const Film& film, int spacing, int map);

class FilmPencils {
public:
    FilmPencils(Kernels& kernels, const Film& film, const FilmLattice& lattice);

    /// Gathers, refines, gathers.
    void refine(SurfaceSolver& solver, const TexelPoints& points);

    int count() const { return pencils_.count + singles_.count; }

    /// Adds reflected irradiance to the surfels of the film.
    void project(Buffer<float>& outgoing);

private:
    void place(const std::vector<int>& pixels, int spacing);
    std::vector<unsigned char> uncovered(int spacing);
    std::vector<int> finer_pixels(const std::vector<unsigned char>& uncovered, int spacing) const;
    void place_singles(const std::vector<unsigned char>& uncovered);

    Kernels& kernels_;
    const Film& film_;
    FilmLattice lattice_;
    int finest_ = 1;  // spacing that refine() went down to
    std::vector<unsigned char> counts_;
    std::vector<int> first_;
    std::vector<int> at_;
    Buffer<int> pencil_at_;
    SurfacePencils pencils_;
    Buffer<unsigned char> uncovered_;  // by surfel
    SurfacePencils singles_;           // of surfels that the finest lattice leaves uncovered
    Buffer<int> single_at_;            // by surfel, -1: none
    int gathered_ = 0;
};

}  // namespace pencil
