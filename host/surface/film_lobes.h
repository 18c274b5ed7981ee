// What the film shows along the lobes of its surfaces: mirrors, gloss, and bases that look at where light comes from.
#pragma once

#include "film/frame.h"
#include "surface/surface_solver.h"

namespace pencil {

struct FilmLobes {
    const Buffer<float>& before;  // the frame's outgoing() without the light of film pencils
    double film_rays;             // of their texels: chains are a share of them
    bool drawn;                   // packets have drawn light samples, also for lobes (sample_lights)
};

/// Adds to the frame's outgoing() what chains find, and light samples on lobes unless they were drawn.
void add_film_lobes(RenderContext& context, Frame& frame, SurfaceSolver& solver, const FilmLobes& lobes);

}  // namespace pencil
