#include "surface/surface_method.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"
#include "surface/explain_bounces.h"
#include "surface/film_lobes.h"
#include "surface/film_seeds.h"
#include "surface/sample_lights.h"
#include "util/error.h"

namespace pencil {

namespace {

/// Width of the maps of those that look, between them, whether anything is missed. So many join them at most for each one; and this share of what is
/// seen is no reason to place a set once more.
constexpr int look_map = 4;
constexpr std::size_t most_missed = 4;
constexpr double tolerated_miss = 1e-3;
/// Rays of the world set for each one of the film pencils.
constexpr double world_share = 0.15;
/// Width of the maps of the world set, and of the first ones, before the film's rays are known.
constexpr int least_world_map = 4, most_world_map = 32, first_world_map = 12;
/// Rays of film pencils for each path that checks the image: it costs as much as so many in ten, which see things together.
constexpr double rays_per_check = 32;
/// So long that a path of a check costs as assumed there [reflections], and so long that most of them are cut (trace_checks.cl).
constexpr double usual_check = 50, longest_check = 200;
/// The same of sensors: they are measured, so much of the time goes into knowing how well.
constexpr double sensor_rays_per_check = 4;
/// Residual of reflections that float's rounding may leave at high albedos: no reason to warn.
constexpr double least_residual = 1e-3;

double mean_of(const glm::dvec3& rgb) { return (rgb.x + rgb.y + rgb.z) / 3; }

Buffer<float> copy_of(const Kernels& kernels, const Buffer<float>& values, const std::string& what) {
    Buffer<float> copy(kernels.device(), values.size(), what);
    copy.copy_from(values, 0, 0, values.size());
    return copy;
}

/// Layers of light: those of surfaces hardly gain from further passes.
std::vector<std::string> light_layers(const std::vector<std::string>& aovs) {
    std::vector<std::string> layers;
    for (const std::string& group : light_groups())
        if (has_group(aovs, group)) layers.push_back(group);
    return layers;
}

}  // namespace

SurfaceMethod::SurfaceMethod(RenderContext& context)
    : context_(context), begun_(context.clock.seconds()), patience_(context.options.target_error), mean_(context) {
    for (std::size_t i = 0; i < context.forms.size(); ++i)
        emitters_ += context.scene.shapes[i].emits && context.forms[i] == LightForm::samples ? 1 : 0;
}

SurfacePass SurfaceMethod::pass(int index) const {
    SurfacePass pass = surface_pass(index, context_.options, context_.flat.camera, emitters_);
    if (!context_.scene.sensor_points.empty()) suit_sensors(pass, count_receivers(context_.scene));
    pass.world.pencils = std::max(pass.world.pencils >> course_.thrift, 1);
    pass.world.thrift = course_.thrift;
    return pass;
}

/// The mean's sequences take turns.
Turn SurfaceMethod::turn(int index) const {
    const auto i = static_cast<std::uint64_t>(index);
    return {hash64(hash64(context_.options.seed) - i % LayerMean::sequences - 1), i / LayerMean::sequences};
}

bool SurfaceMethod::advance() {
    const double work = pass(course_.index).work;
    bool lit = false;
    try {
        lit = add_pass();
    } catch (const MemoryError& error) {
        if (mean_.count() == 0) throw;
        context_.stats.stopped = fmt::format("stopped after {} passes: {}", mean_.count(), error.what());
        return false;
    }
    const double time = context_.clock.seconds(), pace = (time - begun_) / work;
    begun_ = time;
    ++course_.index;
    if (solver_) course_.solver = solver_->course();
    return lit && !enough(pace);
}

/// A pass, if need be with less memory. What fails leaves no trace.
bool SurfaceMethod::add_pass() {
    while (true) {
        const PassCourse before = course_;
        const RenderStats stats = context_.stats;
        const auto undo = [&] {
            course_ = before;
            if (mean_.count() > 0) context_.stats = stats;
        };
        try {
            return add_pass(pass(course_.index));
        } catch (const MemoryError& error) {
            undo();
            if (!be_thrifty(error)) throw;
        } catch (...) {
            undo();
            throw;
        }
    }
}

/// The world set gives memory back, and takes half of it from now on. False if that has been tried often enough.
bool SurfaceMethod::be_thrifty(const MemoryError& error) {
    if (course_.thrift == most_thrift) return false;
    ++course_.thrift;
    course_.world_set = -1;
    solver_ = nullptr;
    frame_ = nullptr;
    context_.stats.warnings.push_back(
        fmt::format("device memory is short: pass {} starts again with half as large a world set ({})", course_.index + 1, error.what()));
    return true;
}

void SurfaceMethod::begin_frame(int index, const SurfacePass& pass, const std::vector<std::string>& aovs,
                                const std::vector<unsigned char>& split) {
    frame_ = std::make_unique<Frame>(context_, aovs, pass.light_samples, 0, turn(index), split);
}

/// Half a pass is worth nothing beside whole ones: only whole ones join the mean. False if nothing can be added to the direct light.
bool SurfaceMethod::add_pass(const SurfacePass& pass) {
    const std::vector<std::string>& aovs = context_.options.aovs;
    const std::vector<unsigned char> split = course_.thrift > 0 ? std::vector<unsigned char>() : mean_.noisy_pixels();
    if (pass.world_set != course_.world_set) course_.placed_split = split;
    begin_frame(course_.index, pass, course_.index == 0 ? aovs : light_layers(aovs), split);
    const Turn now = turn(course_.index);
    const std::vector<float> emission = frame_->layers().beauty();
    const bool lit = add_direct(pass, hash64(now.seed + 2) + now.index);
    if (lit) add_bounces(pass, now);
    mean_.add(frame_->take_layers(), emission, pass);
    frame_ = nullptr;
    context_.stats.passes = mean_.count();
    course_.work += 1;
    return lit;
}

/// Light of the samples: of all of them, or of those that packets draw. False if nothing can be added to the direct light.
bool SurfaceMethod::add_direct(const SurfacePass& pass, std::uint64_t seed) {
    const LightSet& lights = frame_->lights();
    if (fewer_lights(pass, lights.maps.count) == 1) return frame_->add_direct();
    return frame_->add_direct([&] {
        sample_lights(context_.kernels, context_.device_scene, frame_->film().surfels(), lights, 1, film_draws(pass),
                      static_cast<uint>(hash64(seed) >> 32), frame_->outgoing());
    });
}

/// The world set of the passes from this one on, from what its frame shows.
void SurfaceMethod::place_world(const SurfacePass& pass, const FilmPixels& pixels) {
    const std::uint64_t seed = hash64(hash64(context_.options.seed) + static_cast<std::uint64_t>(pass.world_set) + 1);
    SurfaceLights lights = surface_lights(context_, context_.kernels.device(), pass, frame_->light_samples(), seed);
    solver_ = nullptr;  // its memory first
    solver_ = std::make_unique<SurfaceSolver>(context_.kernels, context_.device_scene, std::move(lights), pass.world, context_.clock,
                                              static_cast<uint>(seed >> 32), context_.helpers);
    solver_->know(course_.solver.spots);
    for (const auto& copy : context_.copies)
        if (copy->failure.empty())
            solver_->add_helper(*copy,
                                [&] { return surface_lights(context_, copy->kernels.device(), pass, frame_->light_samples(), seed); });
    course_.missed_before = course_.missed;
    if (context_.wanted(2)) cover_world(pixels);
}

/// Places the world set of the next pass once more, if those before share it.
void SurfaceMethod::resume() {
    begun_ = context_.clock.seconds();
    context_.clock.allow_stops();
    if (course_.world_set < 0 || course_.world_set != pass(course_.index).world_set) return;
    const SurfacePass placing = pass(course_.placed_by);
    begin_frame(course_.placed_by, placing, {}, course_.placed_split);
    course_.missed = course_.missed_before;
    place_world(placing, FilmPixels(frame_->film()));
    solver_->resume(course_.solver);
    frame_ = nullptr;
}

void SurfaceMethod::transfer(Archive& archive) {
    double seconds = context_.clock.seconds();
    archive(course_, patience_, seconds, context_.receivers);
    transfer_stats(context_.stats, archive);
    mean_.transfer(archive);
    if (!archive.reads()) return;
    Archive::expect(archive.remaining() == 0 && course_.index == mean_.count(), "there is more or less than a solve");
    Archive::expect(std::isfinite(seconds) && seconds >= 0, "time is none");
    course_.expect_pixels(static_cast<std::size_t>(context_.flat.camera.width) * static_cast<std::size_t>(context_.flat.camera.height));
    context_.clock.go_on_after(seconds);
    resume();
}

/// Places it on what the film sees. Seeds are few: pixels between them look whether anything is missed, and are seeds of the sets to come.
void SurfaceMethod::cover_world(const FilmPixels& pixels) {
    Kernels& kernels = context_.kernels;
    if (pixels.film.is_row_of_sensors()) return solver_->place(seed_sensors(kernels, pixels.film, film_map), course_.guess);
    std::vector<uint> seeds = seeding_pixels(pixels, context_.flat.camera);
    const std::size_t most = most_missed * seeds.size();
    seeds.insert(seeds.end(), course_.missed.begin(), course_.missed.end());
    solver_->place(seed_pencils(kernels, pixels, seeds, film_map), course_.guess);
    WorldSet::Missed missed = solver_->missed(seed_pencils(kernels, pixels, looking_pixels(pixels, context_.flat.camera, seeds), look_map));
    missed.keys = some_of(missed.keys, most - std::min(most, course_.missed.size()));
    course_.missed.insert(course_.missed.end(), missed.keys.begin(), missed.keys.end());
    if (missed.share <= tolerated_miss || missed.keys.empty()) return;
    seeds.insert(seeds.end(), missed.keys.begin(), missed.keys.end());
    solver_->place(seed_pencils(kernels, pixels, seeds, film_map), solver_->spacing());
}

/// Width of the maps of the world set for about so many rays, a multiple of 4.
int SurfaceMethod::world_map(double rays) const {
    const double texels = std::ldexp(rays, -course_.thrift) / std::max(solver_->world().count, 1);
    return std::clamp(4 * static_cast<int>(std::lround(std::sqrt(texels) / 4)), least_world_map, most_world_map);
}

/// The world's noise is not to outweigh the film's, as the last passes say.
void SurfaceMethod::solve_world(const Turn& turn) {
    const double film = course_.film_rays, least = world_share * film;
    const int usual = film > 0 ? world_map(least) : first_world_map;
    const int map = film > 0 ? std::max(usual, world_map(course_.balance.rays(film, course_.pixel_noise, course_.mean_noise))) : usual;
    solver_->solve(map, context_.options.bounces, context_.options.tolerance, hash64(turn.seed) + turn.index);
    const double count = solver_->world().count;
    if (film > 0) course_.work += (film + count * map * map) / (film + count * usual * usual) - 1;
}

/// Adds all reflections from order 2 on, and of order 1 what light samples do not carry, to the frame, as one layer "indirect".
void SurfaceMethod::add_bounces(const SurfacePass& pass, const Turn& turn) {
    if (!context_.wanted(1)) return;
    if (frame_->film().surfels().count == 0) return frame_->finish_bounce(FilmLayers::indirect, 0, 0);  // passes have the same layers
    const FilmPixels pixels(frame_->film());
    if (pass.world_set != course_.world_set) {
        // As many more pencils lie so much closer.
        course_.guess = course_.spacing * std::sqrt(static_cast<float>(course_.wish) / static_cast<float>(pass.world.pencils));
        place_world(pass, pixels);
        course_.wish = pass.world.pencils;
        course_.spacing = solver_->spacing();
        course_.placed_by = course_.index;
        course_.world_set = pass.world_set;
        course_.pixel_noise = mean_.noise_of_pixels();
        course_.mean_noise = mean_.noise_of_mean();
        context_.stats.world_pencils += static_cast<std::uint64_t>(solver_->world().count);
    }
    solve_world(turn);
    report_bounces();
    gather_film(pass, pixels, turn);
    if (const int paths = check_paths(pixels.film.is_row_of_sensors() ? sensor_rays_per_check : rays_per_check); paths > 0)
        context_.clock.run("check error", [&] { mean_.check().add(frame_->film(), paths, hash64(turn.seed + 1) + turn.index); });
}

/// What film pencils gather from the world set, and reflections of surfels with lobes.
void SurfaceMethod::gather_film(const SurfacePass& pass, const FilmPixels& pixels, const Turn& turn) {
    FilmPencils film(context_.kernels, pixels, pass.lattice);
    const TexelPoints points{static_cast<uint>(turn.seed >> 32), static_cast<uint>(turn.index)};
    context_.clock.run("film pencils", [&] { film.refine(*solver_, points); });
    context_.stats.film_pencils += static_cast<std::uint64_t>(film.count());
    course_.film_rays = film.rays();
    const Buffer<float> before =
        context_.kernels.features().lobes ? copy_of(context_.kernels, frame_->outgoing(), "light before film pencils") : Buffer<float>();
    context_.clock.run("project film", [&] { film.project(frame_->outgoing()); });
    if (before.allocated())
        context_.clock.run("reflections", [&] {
            add_film_lobes(context_, *frame_, *solver_, {before, course_.film_rays, fewer_lights(pass, frame_->lights().maps.count) > 1});
        });
    frame_->finish_bounce(FilmLayers::indirect, film.count(), 0);
    const double share = mean_of(context_.stats.bounces.back().mean) / std::max(mean_of(mean_rgb(frame_->layers().beauty())), 1e-30);
    course_.balance.add(pass.world_set, solver_->light_to_film(), share, solver_->world_rays());
}

/// About how many reflections matter to a path of a check.
double SurfaceMethod::check_length() const {
    return context_.options.bounces < 0 ? 1 / std::max(1 - context_.stats.bounce_solve.spectral_radius, 1e-9) : 1;
}

/// Paths of a check, one for so many rays, fewer where each is long; 0 where so many reflections matter that paths cannot follow them.
int SurfaceMethod::check_paths(double rays_per_path) const {
    const double length = check_length();
    if (length > longest_check) return 0;
    return static_cast<int>(course_.film_rays / (rays_per_path * std::max(length / usual_check, 1.0)));
}

/// What the world's bounces say of the image.
void SurfaceMethod::report_bounces() {
    RenderStats& stats = context_.stats;
    stats.residual = solver_->residual();
    stats.bounce_solve = solver_->bounces();
    if (!stats.converged || solver_->residual() <= std::max(context_.options.tolerance, least_residual)) return;
    stats.converged = false;
    stats.warnings.push_back(unfinished_bounces(stats.bounce_solve, stats.residual));
}

double SurfaceMethod::estimated_error() const { return mean_.errors().error; }
CertifiedError SurfaceMethod::certified_error() const { return mean_.errors().certified; }

/// True if the next pass is not needed or would not end in time; `pace`: seconds per unit of work.
bool SurfaceMethod::enough(double pace) {
    const RenderOptions& options = context_.options;
    if (!context_.stats.bounce_solve.has_sum) return mean_.count() >= least_passes;  // no pass would make it right
    StageClock& clock = context_.clock;
    if (options.seconds > 0) {
        clock.set_fraction(std::min(clock.seconds() / options.seconds, 1.0));
        return clock.seconds() + pace * pass(course_.index).work > options.seconds;
    }
    const PassErrors errors = mean_.errors();
    if (mean_.count() >= 2) clock.set_fraction(std::min(options.target_error / errors.error, 1.0));
    const Patience::Answer answer =
        patience_.ask({mean_.count(), course_.work, errors.error, errors.sure_error, errors.mean_error, errors.certified});
    context_.stats.stopped = answer.reason.value_or("");
    return answer.enough;
}

std::vector<Layer> SurfaceMethod::snapshot() const {
    if (mean_.count() > 0) return mean_.snapshot();
    return frame_ ? frame_->snapshot() : std::vector<Layer>();
}

std::vector<Layer> SurfaceMethod::take() {
    if (mean_.count() > 0) return mean_.take();
    return frame_ ? frame_->take_layers() : std::vector<Layer>();
}

void SurfaceMethod::let_go() {
    solver_ = nullptr;
    if (mean_.count() > 0) frame_ = nullptr;
}

std::vector<std::string> SurfaceMethod::explain() const {
    std::vector<std::string> lines{
        "visibility: always rays through the hierarchy; no geometry maps, so no choice among ways to make them",
        "indirect light: pencils on surfaces; left out: octahedral maps of pencils, density, weights, shrinking sets"};
    if (context_.stats.bounce_solve.steps > 0) lines.push_back(explain_bounces(context_.stats.bounce_solve, context_.stats.residual));
    if (solver_ && context_.wanted(2))
        lines.push_back(solver_->spots() > 0 ? fmt::format("bright spots: pencils send rays of their own to {}", solver_->spots())
                                             : "left out: rays to bright spots: rays in all directions find the light");
    if (!course_.missed.empty())
        lines.push_back(fmt::format("{} pixels see what the world set's first seeds missed: it begins there, too", course_.missed.size()));
    if (solver_ && course_.film_rays > 0 && check_length() > longest_check)
        lines.push_back("left out: check by light paths (too many reflections matter); the error is that of the spread of passes alone");
    return lines;
}

}  // namespace pencil
