// What each pass of the surface method spends where: passes grow finer, so that noise and error of interpolation both fall with time.
#pragma once

#include "options/render_options.h"
#include "surface/film_pencils.h"

namespace pencil {

/// Width of the maps of film pencils, and of those whose texels show where light is reflected.
constexpr int film_map = 8;

/// Spacing of the coarsest film pencils [pixels], a power of two: about so many across the film whatever its resolution.
int coarsest_spacing(const Camera& film);

/// What one pass spends where.
struct SurfacePass {
    int generation;
    int world_set;            // its number: passes that share it come one after the other
    int light_samples;        // of the film
    bool draws_lights;        // packets of the film's surfels may draw some of them, where each emitter's own makes many
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

/// The same for so many receivers of sensors: they do not help each other, and each is to be known well.
void suit_sensors(SurfacePass& pass, int receivers);

/// Light samples that a packet of the film's surfels draws where it does not take all,
int film_draws(const SurfacePass& pass);
/// and how many light samples, of so many, there are to each one that lights a surfel of the film: a thousand lamps light most places by a few.
double fewer_lights(const SurfacePass& pass, int samples);

}  // namespace pencil
