// Indirect light by pencils on surfaces: a world set for all bounces, film pencils that gather from it, and the film lit by them. An image
// is the mean of passes, which grow finer: noise and interpolation error both fall with time.
#pragma once

#include "film/frame.h"
#include "surface/film_pencils.h"
#include "surface/surface_solver.h"

namespace pencil {

/// What one pass spends where.
struct SurfacePass {
    int generation;
    int world_set;            // its number: passes that share it come one after the other
    int light_samples;        // of the film
    int texel_light_samples;  // that texels of surface pencils draw from
    WorldQuality world;
    FilmLattice lattice;
    double weight;  // its share of the mean, in proportion to the first pass
    double work;    // about how long it takes, in proportion to the first pass
};

/// Pass `index`: each generation has twice the passes of the last, with smaller reuse errors, more pencils and more light samples, and two
/// world sets; `emitters`: shapes that light samples are spread over. The exponents keep the error of interpolation below the noise of the
/// mean as both fall (docs/accuracy.md).
SurfacePass surface_pass(int index, const RenderOptions& options, const Camera& film, int emitters);

class SurfaceMethod {
public:
    explicit SurfaceMethod(RenderContext& context) : context_(context) {}

    /// Adds all reflections from order 2 on, and of order 1 what light samples do not carry, to the frame, as one layer "indirect".
    void add_bounces(const SurfacePass& pass, const Turn& turn, Frame& frame);

private:
    void solve_world(const SurfacePass& pass, const Frame& frame, const FilmPixels& pixels);

    RenderContext& context_;
    int world_set_ = -1;  // of the solver
    std::unique_ptr<SurfaceSolver> solver_;
};

}  // namespace pencil
