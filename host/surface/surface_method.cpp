#include "surface/surface_method.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"

namespace pencil {

namespace {

/// Spacing of the pencils whose texels show where light is reflected, in terms of the coarsest of the first pass.
constexpr int seed_spacing = 4;
/// Width of the maps of film pencils: more pencils with few texels reach further than few with many, once passes enough fill the texels.
constexpr int film_map = 8, fine_film_map = 4;
/// First generation of fine film pencils.
constexpr int fine_generation = 3;
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
/// Time of the first world set, in terms of the time of the first pass without it.
constexpr double world_work = 0.3;

/// Generation g has 2^(g + 1) passes.
int generation_of(int index) {
    int generation = 0;
    while (index >= (4 << generation) - 2) ++generation;
    return generation;
}

/// Each generation has two world sets, for half of its passes each.
int world_set_of(int index) {
    const int generation = generation_of(index), within = index - ((2 << generation) - 2);
    return 2 * generation + (within >> generation);
}

}  // namespace

SurfacePass surface_pass(int index, const RenderOptions& options, const Camera& film, int emitters) {
    const int generation = generation_of(index);
    const auto grown = [&](double exponent) { return std::exp2(exponent * generation); };
    const bool fine = generation >= fine_generation;
    SurfacePass pass{};
    pass.generation = generation;
    pass.world_set = world_set_of(index);
    pass.weight = grown(0.8) * (fine ? 0.6 : 1.0);
    pass.light_samples =
        std::max(static_cast<int>(std::lround(0.5 * options.light_samples * std::clamp(0.5 * emitters, 1.0, 4.0) * grown(0.25))), 1);
    pass.texel_light_samples = std::min(16 * std::min(pass.light_samples, most_texel_samples), most_texel_samples);
    pass.world.pencils = static_cast<int>(std::lround(std::min(options.pencils * std::min(grown(1.0), 64.0), 1048576.0)));
    pass.world.light_draws = light_draws;
    pass.lattice.coarsest = coarsest_spacing(film) / (fine ? 2 : 1);
    pass.lattice.most_error = static_cast<float>((fine ? 0.178 : 0.26) * grown(-0.55));
    pass.lattice.smooth = static_cast<float>((fine ? 0.52 : 0.325) * grown(-0.35));
    pass.lattice.map = fine ? fine_film_map : film_map;
    pass.work = grown(0.5);
    if (index == 0 || world_set_of(index - 1) < pass.world_set) pass.work += world_work * pass.world.pencils / options.pencils;
    return pass;
}

/// The world set of the passes from this one on, from what its frame shows.
void SurfaceMethod::solve_world(const SurfacePass& pass, const Frame& frame, const FilmPixels& pixels) {
    const auto& device = context_.kernels.device();
    const std::uint64_t seed = hash64(hash64(context_.options.seed) + static_cast<std::uint64_t>(pass.world_set) + 1);
    const std::vector<LightSample> samples = sample_lights(context_.scene, context_.flat, context_.forms, pass.texel_light_samples, seed);
    SurfaceLights lights{samples.empty() ? LightSet() : LightSet(device, samples, 0),
                         Buffer<float>(device, near_areas(context_.flat, frame.light_samples()), "near areas of emitters"),
                         Buffer<float>(device, near_areas(context_.flat, samples), "near areas of emitters")};
    world_set_ = pass.world_set;
    solver_ = nullptr;  // its memory first
    solver_ = std::make_unique<SurfaceSolver>(context_.kernels, context_.device_scene, context_.flat, std::move(lights), pass.world,
                                              context_.clock, static_cast<uint>(seed >> 32));
    const int spacing = seed_spacing * coarsest_spacing(context_.flat.camera);
    solver_->solve(seed_pencils(context_.kernels, pixels, spacing, film_map), context_.options.bounces, context_.options.tolerance);
    context_.stats.world_pencils += static_cast<std::uint64_t>(solver_->world().count);
    context_.stats.residual = solver_->residual();
}

void SurfaceMethod::add_bounces(const SurfacePass& pass, const Turn& turn, Frame& frame) {
    if (!context_.wanted(1) || context_.clock.stopped()) return;
    if (frame.film().surfels().count == 0) return frame.finish_bounce(FilmLayers::indirect, 0, 0);  // passes have the same layers
    const FilmPixels pixels(frame.film());
    if (pass.world_set != world_set_) solve_world(pass, frame, pixels);
    if (context_.clock.stopped()) return;
    FilmPencils film(context_.kernels, pixels, pass.lattice);
    const TexelPoints points{static_cast<uint>(turn.seed >> 32), static_cast<uint>(turn.index)};
    context_.clock.run("film pencils", [&] { film.refine(*solver_, points); });
    context_.stats.film_pencils += static_cast<std::uint64_t>(film.count());
    context_.clock.run("project film", [&] { film.project(frame.outgoing()); });
    frame.finish_bounce(FilmLayers::indirect, film.count(), 0);
}

}  // namespace pencil
