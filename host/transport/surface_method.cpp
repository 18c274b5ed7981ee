#include "transport/surface_method.h"

#include <algorithm>
#include <cmath>

namespace pencil {

namespace {

/// Spacing of the film pencils whose texels show where light is reflected [pixels], and the width of their maps.
constexpr int seed_spacing = 32;
constexpr int seed_map = 8;

int generation_of(int index) {
    int generation = 0;
    while (index >= (2 << generation) - 1) ++generation;
    return generation;
}

}  // namespace

SurfacePass surface_pass(int index, const RenderOptions& options) {
    const int generation = generation_of(index);
    const double finer = std::exp2(-0.5 * generation), more = 1.0 / finer;
    SurfacePass pass{};
    pass.weight = more;
    pass.light_samples = std::max(static_cast<int>(std::lround(0.5 * options.light_samples * more)), 1);
    pass.light_map = generation < 2 ? 128 : 256;
    pass.world.pencils = static_cast<int>(std::lround(options.pencils * std::min(more * more, 64.0)));
    pass.world.light_stride = std::max(pass.light_samples / 16, 1);
    pass.lattice.coarsest = std::max(8 >> generation / 2, 2);
    pass.lattice.most_error = static_cast<float>(0.35 * finer);
    pass.lattice.smooth = static_cast<float>(0.25 * finer);
    pass.lattice.map = generation < 4 ? 12 : 16;
    return pass;
}

void add_surface_bounces(RenderContext& context, const DeviceBvh& bvh, const SurfacePass& pass, Frame& frame, std::uint64_t seed) {
    if (!context.wanted(context.maps_emit ? 1 : 2) || context.clock.stopped()) return;
    SurfaceSolver solver(context.kernels, context.device_scene, context.flat, bvh, frame.lights(), pass.world, context.clock, seed);
    FilmPencils seeds(context.kernels, frame.film(), {seed_spacing, seed_spacing, 0.0F, seed_map, 0.0F});
    solver.solve(seeds.pencils(), context.options.bounces, context.options.tolerance);
    FilmPencils film(context.kernels, frame.film(), pass.lattice);
    context.clock.run("film pencils", [&] { film.refine(solver); });
    context.stats.world_pencils += static_cast<std::uint64_t>(solver.world().count);
    context.stats.film_pencils += static_cast<std::uint64_t>(film.pencils().count);
    context.stats.residual = solver.residual();
    context.clock.run("project film", [&] { film.project(frame.outgoing()); });
    frame.finish_bounce(FilmLayers::indirect, film.pencils().count, 0);
}

}  // namespace pencil
