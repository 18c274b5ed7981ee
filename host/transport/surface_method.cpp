#include "transport/surface_method.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// Spacing of the film pencils whose texels show where light is reflected, in terms of the coarsest of the first pass.
constexpr int seed_spacing = 4;
/// Width of the maps of film pencils: more pencils with few texels reach further than few with many.
constexpr int film_map = 8;
/// Light samples that a packet of texels draws.
constexpr int light_draws = 2;

/// Spacing of the coarsest film pencils [pixels], a power of two: about so many across the film whatever its resolution.
int coarsest_spacing(const Camera& film) {
    int spacing = 4;
    while (spacing < 32 && std::min(film.width, film.height) >= 128 * spacing) spacing *= 2;
    return spacing;
}

/// Texels draw from at most so many light samples.
constexpr int most_texel_samples = 1 << 16;

int generation_of(int index) {
    int generation = 0;
    while (index >= (2 << generation) - 1) ++generation;
    return generation;
}

}  // namespace

SurfacePass surface_pass(int index, const RenderOptions& options, const Camera& film, int emitters) {
    const int generation = generation_of(index);
    const auto grown = [&](double exponent) { return std::exp2(exponent * generation); };
    SurfacePass pass{};
    pass.weight = grown(0.8);
    pass.work = grown(0.5);
    pass.light_samples =
        std::max(static_cast<int>(std::lround(0.5 * options.light_samples * std::clamp(0.5 * emitters, 1.0, 4.0) * grown(0.25))), 1);
    pass.texel_light_samples = std::min(16 * std::min(pass.light_samples, most_texel_samples), most_texel_samples);
    pass.world.pencils = static_cast<int>(std::lround(std::min(options.pencils * std::min(grown(0.75), 64.0), 1048576.0)));
    pass.world.light_draws = light_draws;
    pass.lattice.coarsest = std::max(coarsest_spacing(film) >> generation / 4, 2);
    pass.lattice.most_error = static_cast<float>(0.175 * grown(-0.35));
    pass.lattice.smooth = static_cast<float>(0.25 * grown(-0.25));
    pass.lattice.map = film_map;
    return pass;
}

void add_surface_bounces(RenderContext& context, const SurfacePass& pass, Frame& frame, std::uint64_t seed) {
    if (!context.wanted(1) || context.clock.stopped() || frame.film().surfels().count == 0) return;
    const auto& device = context.kernels.device();
    const std::vector<LightSample> samples =
        sample_lights(context.scene, context.flat, context.forms, pass.texel_light_samples, hash64(seed + 1));
    const SurfaceLights lights{samples.empty() ? LightSet() : LightSet(device, samples, 0),
                               Buffer<float>(device, near_areas(context.flat, frame.light_samples()), "near areas of emitters"),
                               Buffer<float>(device, near_areas(context.flat, samples), "near areas of emitters")};
    SurfaceSolver solver(context.kernels, context.device_scene, context.flat, lights, pass.world, context.clock, seed);
    const int spacing = seed_spacing * coarsest_spacing(context.flat.camera);
    FilmPencils seeds(context.kernels, frame.film(), {spacing, 0.0F, film_map, 0.0F});
    solver.solve(seeds.pencils(), context.options.bounces, context.options.tolerance);
    if (context.clock.stopped()) return;
    FilmPencils film(context.kernels, frame.film(), pass.lattice);
    context.clock.run("film pencils", [&] { film.refine(solver); });
    context.stats.world_pencils += static_cast<std::uint64_t>(solver.world().count);
    context.stats.film_pencils += static_cast<std::uint64_t>(film.count());
    context.stats.residual = solver.residual();
    context.clock.run("project film", [&] { film.project(frame.outgoing()); });
    frame.finish_bounce(FilmLayers::indirect, film.count(), 0);
}

}  // namespace pencil
