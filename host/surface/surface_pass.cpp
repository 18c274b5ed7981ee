#include "surface/surface_pass.h"

#include <algorithm>
#include <cmath>

namespace pencil {

namespace {

/// Light samples that a packet of texels draws.
constexpr int light_draws = 2;
/// Texels draw from at most so many light samples.
constexpr int most_texel_samples = 1 << 16;
/// Rays of the pencils of all sensors and shadow rays of all, about, as many as of a small film, but maps and samples of each at most.
constexpr double sensor_rays = 1 << 17;
constexpr int most_sensor_map = 128, most_sensor_lights = 1 << 12;
/// Of more light samples than this, and than twice what was asked for, surfels draw, at least so many.
constexpr int many_lights = 256, least_draws = 64;
/// Time of the first world set, in terms of the time of the first pass without it.
constexpr double world_work = 0.3;

/// Generation g has 2^(g + 1) passes.
int generation_of(int index) {
    int generation = 0;
    while (index >= (4 << generation) - 2) ++generation;
    return generation;
}

/// Each generation has two world sets, for half of its passes each: where pencils lie is an error that only passes of different sets show.
int world_set_of(int index) {
    const int generation = generation_of(index), within = index - ((2 << generation) - 2);
    return 2 * generation + (within >> generation);
}

}  // namespace

int coarsest_spacing(const Camera& film) {
    int spacing = 2;
    while (spacing < 16 && std::min(film.width, film.height) >= 256 * spacing) spacing *= 2;
    return spacing;
}

SurfacePass surface_pass(int index, const RenderOptions& options, const Camera& film, int emitters) {
    const int generation = generation_of(index);
    const auto grown = [&](double exponent) { return std::exp2(exponent * generation); };
    SurfacePass pass{};
    pass.generation = generation;
    pass.world_set = world_set_of(index);
    pass.weight = grown(0.8);
    pass.light_samples =
        std::max(static_cast<int>(std::lround(0.5 * options.light_samples * std::clamp(0.5 * emitters, 1.0, 4.0) * grown(0.25))), 1);
    pass.draws_lights = true;
    pass.texel_light_samples = std::min(16 * std::min(pass.light_samples, most_texel_samples), most_texel_samples);
    pass.world.pencils = static_cast<int>(std::lround(std::min(options.pencils * std::min(grown(0.5), 16.0), 1048576.0)));
    pass.world.light_draws = light_draws;
    pass.lattice.coarsest = coarsest_spacing(film);
    pass.lattice.most_error = static_cast<float>(0.3 * grown(-0.55));
    pass.lattice.smooth = static_cast<float>(0.3 * grown(-0.35));
    pass.lattice.map = film_map;
    pass.work = grown(0.5);
    if (index == 0 || world_set_of(index - 1) < pass.world_set) pass.work += world_work * pass.world.pencils / options.pencils;
    return pass;
}

void suit_sensors(SurfacePass& pass, int receivers) {
    const double each = sensor_rays / receivers;
    pass.lattice.coarsest = 0;
    pass.lattice.map = std::clamp(4 * static_cast<int>(std::lround(std::sqrt(each) / 4)), film_map, most_sensor_map);
    pass.light_samples = std::max(pass.light_samples, std::min(static_cast<int>(each), most_sensor_lights));
    pass.draws_lights = false;
}

int film_draws(const SurfacePass& pass) { return std::max(pass.light_samples, least_draws); }

double fewer_lights(const SurfacePass& pass, int samples) {
    const bool many = pass.draws_lights && samples > std::max(many_lights, 2 * pass.light_samples);
    return many ? static_cast<double>(samples) / film_draws(pass) : 1;
}

}  // namespace pencil
