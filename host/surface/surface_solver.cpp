#include "surface/surface_solver.h"

#include <algorithm>
#include <glm/gtx/component_wise.hpp>
#include <limits>

#include "film/bounce_series.h"
#include "pencils/low_discrepancy.h"
#include "surface/close_series.h"
#include "surface/emit_chains.h"
#include "surface/emit_hemispheres.h"
#include "surface/follow_surfels.h"
#include "surface/krylov.h"
#include "surface/sum_hemispheres.h"
#include "surface/transport_irradiance.h"

namespace pencil {

namespace {

/// Texels that are worked on at once: bounds memory (18 MB) and the length of a launch.
constexpr int chunk_surfels = 1 << 18;
/// Bounces of the world set that are added one by one if their number is not limited: where they leave more, GMRES is faster.
constexpr int most_steps = 16;
/// Applications of transport after them at most.
constexpr int most_iterations = 256;
/// Bounces from which on the series is geometric enough to stop: light of the samples joins in the first, and ratios need two more.
constexpr int least_iterations = 3;
/// The world's bounces stop at this share of the tolerance of the image.
constexpr double tolerance_share = 0.1;

glm::dvec3 power(const Buffer<float4>& irradiance) {
    glm::dvec3 sum(0);
    for (const float4& e : irradiance.read()) sum += glm::dvec3(e);
    return sum;
}

}  // namespace

SurfaceSolver::SurfaceSolver(Kernels& kernels, const DeviceScene& scene, SurfaceLights lights, const WorldQuality& quality,
                             StageClock& clock, uint seed, HelperReport& helpers)
    : kernels_(kernels),
      scene_(scene),
      lights_(std::move(lights)),
      quality_(quality),
      clock_(clock),
      seed_(seed),
      world_(kernels, scene, quality.pencils, seed_, lights_.drawn),
      gatherer_(kernels, scene, lights_, quality.light_draws, chunk_surfels >> quality.thrift),
      search_(kernels, scene, lights_, world_, gatherer_),
      guides_(kernels),
      team_(kernels, helpers) {}

SurfaceSolver::Course SurfaceSolver::course() const { return {gathers_, looked_, spots_.found}; }

void SurfaceSolver::resume(const Course& course) {
    gathers_ = course.gathers;
    looked_ = course.looked_for_spots;
    know(course.spots);
}

void SurfaceSolver::know(const std::vector<Spot>& spots) { spots_ = DeviceSpots(kernels_.device(), spots); }

void SurfaceSolver::place(const SurfacePencils& seeds, float spacing) {
    clock_.run(
        "place world", [&] { world_.cover(seeds, spacing); });
}

WorldSet::Missed SurfaceSolver::missed(const SurfacePencils& looks) const {
    WorldSet::Missed missed;
    clock_.run("place world", [&] { missed = world_.missed(looks); });
    return missed;
}

void SurfaceSolver::solve(int map, int orders, double tolerance, std::uint64_t seed) {
    limited_ = orders >= 0;
    direct_ = !limited_ || orders >= 2;
    contacts_ = !limited_ || orders >= 3;
    seed_ = static_cast<uint>(hash64(seed) >> 32);
    if (!direct_ || world_.pencils().count == 0) return inform_team();  // film pencils see no reflections
    if (!looked_) clock_.run("bright spots", [&] { adopt(search_.ahead(spots_.found, seed_of_search())); });
    clock_.run("world pencils", [&] {
        world_.gather(map, seed);
        guides_.trace(gatherer_, spots_, spots_.count > 0 ? next_seed() : 0, world_);
    });
    clock_.run("world bounces", [&] {
        iterate(orders, tolerance);
        if (!looked_) look_for_spots();  // so few orders that the world set needs no light of the samples
    });
    inform_team();
}

/// Each draws other light samples.
std::uint64_t SurfaceSolver::next_seed() { return hash64((std::uint64_t{seed_} << 32) + ++gathers_); }

/// What is looked at to find spots is lit by other draws than what is gathered with them.
std::uint64_t SurfaceSolver::seed_of_search() const { return hash64(std::uint64_t{seed_} + 1) >> 32; }

Chains SurfaceSolver::follow(const Surfels& film, const Buffer<int>& starts, const FilmChains& each) {
    return follow_surfels(kernels_, scene_, film, starts, each, {lights_.film, lights_.chains}, static_cast<uint>(next_seed() >> 32));
}

Buffer<float> SurfaceSolver::radiance(const Surfels& chains) {
    Buffer<float> radiance = surfel_rgb(kernels_.device(), chains.capacity, "radiance of chains");
    emit_chains(kernels_, scene_, chains, radiance);
    if (direct_) Gatherer(kernels_, scene_, lights_, chain_draws, 0).light(chains, radiance, next_seed() >> 32);
    world_.add_reflected(chains, {world_.pencils(), 0}, radiance);
    return radiance;
}

void SurfaceSolver::light_field(Surfels& seen, const Viewers& viewers, std::uint64_t seed, Buffer<float>& radiance) {
    gatherer_.follow(seen, hash64(seed + 1) >> 32, viewers);
    gatherer_.light(seen, radiance, hash64(seed + 2) >> 32, viewers);
    world_.add_reflected(seen, viewers, radiance);
    if (!kernels_.features().lobes) return;
    Buffer<float> not_seen(kernels_.device(), lights_.near_texel.size(), "emission that is not seen without lobes");
    not_seen.fill_zero();
    emit_hemispheres(kernels_, scene_, seen, viewers, not_seen, radiance);
}

void SurfaceSolver::gather(SurfacePencils& pencils, int first, int count, const TexelPoints& points, Reach reach) {
    team_.gather(gatherer_, source(), {points, reach, next_seed()}, pencils, first, count);
}

GatherSource SurfaceSolver::source() const {
    return {world_.pencils(), shorter_, world_.grid(), has_spots() ? &spots_ : nullptr, direct_, contacts_};
}

void SurfaceSolver::add_helper(DeviceCopy& copy, const std::function<SurfaceLights()>& lights) {
    team_.add(
        copy, [&] { return std::make_unique<GatherHelper>(copy, lights(), quality_.light_draws, chunk_surfels >> quality_.thrift); });
}

/// Helpers read the world set as it is now.
void SurfaceSolver::inform_team() {
    if (team_.alone()) return;
    const SurfacePencils& world = world_.pencils();
    const auto count = static_cast<std::size_t>(world.count);
    HostWorld solved{world.n, world.data.read(0, count), world.irradiance.read(0, count), {}, {}, direct_, contacts_};
    if (shorter_.allocated()) solved.shorter = shorter_.read(0, count);
    if (has_spots()) solved.spots = spots_.found;
    team_.take_world(solved);
}

bool SurfaceSolver::has_spots() const { return direct_ && spots_.count > 0; }

/// Bright spots among what the world set sees, where no bounce has looked for them.
void SurfaceSolver::look_for_spots() {
    looked_ = true;
    if (lights_.samples.maps.count == 0) return;
    Buffer<float> outgoing = surfel_rgb(kernels_.device(), world_.surfels().capacity, "radiance to the world set");
    gatherer_.light(world_.surfels(), outgoing, seed_);
    adopt(search_.among_seen(outgoing));
}

/// Spots of this world set, and those of others that it has missed.
void SurfaceSolver::adopt(const std::vector<Spot>& found) {
    std::vector<Spot> all = found;
    for (const Spot& old : spots_.found)
        if (std::none_of(found.begin(), found.end(), [&](const Spot& s) { return holds(s, old.centre) || holds(old, s.centre); }))
            all.push_back(old);
    know(all);
}

/// Irradiance of all pencils of the world set from emitters near them, or from reflected light of the light samples.
void SurfaceSolver::sum_light(Light light, Buffer<float4>& irradiance) {
    const SurfacePencils& pencils = world_.pencils();
    Buffer<float> outgoing = surfel_rgb(kernels_.device(), world_.surfels().capacity, "radiance to the world set");
    if (light == Light::emission)
        emit_hemispheres(kernels_, scene_, world_.surfels(), {world_.starts(), 0}, lights_.near_texel, outgoing);
    else
        gatherer_.light(world_.surfels(), outgoing, seed_);
    // Texels in which spots are found are not to count less where they found them: only the next ones share them with rays.
    const bool guided = light == Light::emission ? guides_.shine() : guides_.any(), looks = light == Light::direct && !looked_;
    std::vector<Spot> found;
    if (looks) found = search_.among_seen(outgoing);
    if (guided) guides_.share(world_, outgoing);
    sum_hemispheres(kernels_, outgoing, world_.surfels().capacity, 0, 0, pencils.count, world_.map(), irradiance);
    if (guided && light == Light::emission) guides_.add_emission(gatherer_, lights_.near_texel, world_, irradiance);
    if (guided && light == Light::direct) guides_.add_light(gatherer_, world_, irradiance);
    if (!looks) return;
    looked_ = true;
    adopt(found);
}

/// Step k is irradiance that the film's pencils reflect as order k + 2: it starts with emission, and reflected light of the
/// light samples joins in step 1. The world's irradiance grows to the sum of all steps.
void SurfaceSolver::iterate(int orders, double tolerance) {
    SurfacePencils& world = world_.pencils();
    const auto count = static_cast<std::size_t>(world.count);
    if (count == 0) return;
    if (limited_) shorter_ = Buffer<float4>(kernels_.device(), count, "irradiance of fewer bounces");
    Buffer<float4> source(kernels_.device(), count, "irradiance of a bounce"), target(kernels_.device(), count, "irradiance of a bounce");
    sum_light(Light::emission, source);
    world.irradiance.copy_from(source, 0, 0, count);
    BounceSeries series;
    series.add(power(source));
    bounces_ = {};
    bool ended = false;
    const int most = limited_ ? orders - 2 : most_steps;
    for (int k = 1; k <= most && !ended; ++k) {
        target.fill_zero();
        if (limited_) shorter_.copy_from(world.irradiance, 0, 0, count);
        if (k == 1 && lights_.samples.maps.count > 0) sum_light(Light::direct, target);
        transport_irradiance(kernels_, world_.surfels(), world_.links(), world.count, world_.map(), source, target, world.irradiance);
        std::swap(source, target);
        // The series begins where all light has joined it.
        if (k == 1) series = {};
        series.add(power(source));
        bounces_.steps = k;
        ended = !limited_ && k >= least_iterations && series.last_share() <= tolerance * tolerance_share;
    }
    if (limited_)
        residual_ = 0;
    else if (ended)
        close_series(series, source);
    else
        solve_rest(source, tolerance * tolerance_share);
}

/// A series that has fallen fast ends as a geometric one.
void SurfaceSolver::close_series(const BounceSeries& series, const Buffer<float4>& last) {
    const glm::vec3 tail(series.tail_factor());
    residual_ = glm::compMax(glm::dvec3(tail)) * series.last_share();
    bounces_.spectral_radius = glm::compMax(series.ratio());
    pencil::close_series(kernels_, last, tail, world_.pencils().count, world_.pencils().irradiance);
}

/// What all reflections after the last add, x = T last + T x.
void SurfaceSolver::solve_rest(const Buffer<float4>& last, double tolerance) {
    SurfacePencils& world = world_.pencils();
    Buffer<float4> next(kernels_.device(), last.size(), "irradiance of the next bounce"),
        unused(kernels_.device(), last.size(), "sums of bounces");
    const Transport transport = [&](const Buffer<float4>& source, Buffer<float4>& target) {
        target.fill_zero();
        transport_irradiance(kernels_, world_.surfels(), world_.links(), world.count, world_.map(), source, target, unused);
    };
    transport(last, next);
    const KrylovReport report = solve_reflections(kernels_, transport, next, world.count, tolerance, most_iterations, world.irradiance);
    bounces_.krylov = report.applications + 1;
    bounces_.spectral_radius = glm::compMax(report.spectral_radius);
    bounces_.has_sum = !has_no_sum(report.spectral_radius);
    residual_ = bounces_.has_sum ? glm::compMax(report.error) : std::numeric_limits<double>::infinity();
}

}  // namespace pencil
