#include "transport/surface_method.h"

#include "transport/film_pencils.h"

namespace pencil {

void add_surface_bounces(RenderContext& context, const DeviceBvh& bvh, Frame& frame, std::uint64_t seed) {
    const RenderOptions& options = context.options;
    if (!context.wanted(context.maps_emit ? 1 : 2) || context.clock.stopped()) return;
    SurfaceSolver solver(context.kernels, context.device_scene, context.flat, bvh, frame.lights(), options, context.clock, seed);
    FilmLattice lattice{options.coarsest, options.finest, options.most_error, options.film_map, options.smooth};
    FilmLattice sparse = lattice;
    sparse.coarsest = 32;
    sparse.map = 8;
    FilmPencils seeds(context.kernels, frame.film(), sparse);
    solver.solve(seeds.pencils(), options.bounces);
    FilmPencils film(context.kernels, frame.film(), lattice);
    context.clock.run("film pencils", [&] { film.refine(solver); });
    context.stats.explain.push_back("surface pencils: " + std::to_string(solver.world().count) + " in the world, " +
                                    std::to_string(film.pencils().count) + " for the film");
    context.stats.residual = solver.residual();
    context.clock.run("project film", [&] { film.project(frame.outgoing()); });
    frame.finish_bounce(2, film.pencils().count, 0);
}

}  // namespace pencil
