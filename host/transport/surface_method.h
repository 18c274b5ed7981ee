// Indirect light by pencils on surfaces: a world set for all bounces, film pencils that gather from it, and the film lit by them. An image
// is the mean of independent passes, which grow finer: noise and interpolation error both fall with time.
#pragma once

#include "transport/film_pencils.h"
#include "transport/frame.h"
#include "transport/surface_solver.h"

namespace pencil {

/// What one pass spends where.
struct SurfacePass {
    int light_samples;
    int light_map;  // width of a light sample's map [texels]
    WorldSet world;
    FilmLattice lattice;
    double weight;  // work in proportion to the first pass: its share of the mean
};

/// Pass `index`: each generation has twice the passes of the last, with reuse errors smaller by sqrt(2) and more pencils and light samples.
SurfacePass surface_pass(int index, const RenderOptions& options);

/// Adds all reflections from order 2 on (from 1 where maps carry emitters) to the frame, as one layer "indirect".
void add_surface_bounces(RenderContext& context, const DeviceBvh& bvh, const SurfacePass& pass, Frame& frame, std::uint64_t seed);

}  // namespace pencil
