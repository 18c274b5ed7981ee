// What the film shows along the lobes of its surfaces: mirrors, gloss, and bases that look at where light comes from.
#pragma once

#include "film/frame.h"
#include "surface/surface_solver.h"

namespace pencil {

/// Adds to the frame's outgoing() light samples on lobes, unless `drawn`: packets have drawn them (sample_lights), and chains that follow lobes, in
/// number a share of the rays of the film's pencils.
void add_film_lobes(RenderContext& context, Frame& frame, SurfaceSolver& solver, double film_rays, bool drawn);

}  // namespace pencil
