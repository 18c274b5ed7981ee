#include "surface/world_set.h"

#include <algorithm>
#include <cmath>

#include "pencils/low_discrepancy.h"
#include "surface/follow_surfels.h"
#include "surface/measure_hemispheres.h"
#include "surface/project_surface_pencils.h"

namespace pencil {

namespace {

// Chosen by trial for the least error at equal time (docs/accuracy.md) where no other reason is given.

/// Pencils further apart than this in their normals do not stand for each other (REUSE_LEAST_COSINE is the looser bound of use).
constexpr float alike = 0.7F;
/// A pencil is used up to this many spacings away.
constexpr float reach = 1.4F;
/// Things seen from nearer than the spacing get closer pencils, but not closer than this share of it: light changes fast near contacts.
constexpr float near_spacing = 0.5F;
/// What is seen from far gets wider spacings, this share of the distance.
constexpr float far_spacing = 0.08F;
/// The spacing is one with which the first round adds so many of the pencils asked for. Neither area nor extent of the scene matter, only
/// what is seen.
constexpr double first_round = 0.5;
// The search for it: it begins with a share of the harmonic mean distance of what is seen, takes steps up to a factor, and ends within a share.
constexpr float first_guess = 0.2F, least_guess = 0.01F;
constexpr int most_guesses = 6;
constexpr double most_step = 2.5, guess_tolerance = 0.1;
/// All further rounds together.
constexpr double further_rounds = 1;
/// A round takes a spacing at least so many times as wide if its pencils would be more than they may be.
constexpr float step_coarser = 1.3F;
/// Rounds of pencils on what the last round sees: light goes round corners in that many steps at most until the fill.
constexpr int most_rounds = 8;
/// The fill adds at most so many pencils for each one asked for, or so many, where one stands for all that faces a way, this share of the spacing apart.
constexpr double most_fill = 0.5;
constexpr std::size_t least_fill = 32;
constexpr float fill_spacing = 0.25F;
/// Width of the maps from the centres.
constexpr int world_map = 8;
/// A map of a pencil is shared by points that see blocks of it this wide.
constexpr int share_map = 4;
/// Spacings are ordered by powers of two of the width, up to so many.
constexpr int most_octaves = 24;
/// Spacings are at most as wide as the scene [scene units].
constexpr float widest = 2;
constexpr const char* seen_name = "surfels that the world set sees";
/// Step of the order in which surfels are visited: a prime, so that all are, and so far that neighbours come far apart.
constexpr std::size_t visit_stride = 7919;

float median_of(std::vector<float>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

WorldSet::WorldSet(Kernels& kernels, const DeviceScene& scene, int wish, uint seed, const LobeLights& lights)
    : kernels_(kernels),
      scene_(scene),
      lights_(lights),
      wish_(wish),
      seed_(seed),
      pencils_(kernels.device(), wish, world_map),
      seen_surfels_(kernels, wish * world_map * world_map, "surfels of the world set") {
    seen_surfels_.count = 0;
}

void WorldSet::cover(const SurfacePencils& seeds, float spacing) {
    pencils_.count = seen_surfels_.count = 0;
    sources_.clear();
    seen_ = {};
    seeds_ = seeds.count;
    seen_surfels_.reserve(kernels_.device(), seeds_ * pencils_.texels(), seen_name);
    trace_hemispheres(kernels_, scene_, seeds, 0, seeds_, {seed_}, seen_surfels_);
    follow(0, seed_, seen_surfels_);
    seen_.read_pencils(seeds);
    seen_.read_points(seen_surfels_);
    PointThinner thinner(widest, alike);
    const auto most = [&](double per_wish) { return static_cast<std::size_t>(std::ceil(per_wish * wish_)); };
    spacing_ = spacing_for(most(first_round), spacing);
    extend(choose(0, {spacing_, most(1.5 * first_round)}, thinner));
    const std::size_t most_further = static_cast<std::size_t>(pencils_.count) + most(further_rounds);
    for (int round = 1, from = 0; round < most_rounds && from < pencils_.count; ++round) {
        if (static_cast<std::size_t>(pencils_.count) >= most_further) break;
        const std::size_t rest = most_further - static_cast<std::size_t>(pencils_.count);
        const ChosenSurfels chosen = choose((seeds_ + from) * pencils_.texels(), {spacing_, rest / 2 + 1}, thinner);
        from = pencils_.count;
        extend(chosen);
    }
    fill({fill_spacing * spacing_, std::max(most(most_fill), least_fill)});
    shared_ = SharedPoints(seen_.points(), link_seen(), static_cast<std::size_t>(pencils_.count), static_cast<std::size_t>(seeds_),
                           static_cast<std::size_t>(pencils_.texels()));
}

WorldSet::Missed WorldSet::missed(const SurfacePencils& looks) const {
    Missed missed;
    if (looks.count == 0) return missed;
    Surfels surfels(kernels_, looks.count * looks.texels(), "surfels that the film looks at");
    trace_hemispheres(kernels_, scene_, looks, 0, looks.count, {seed_}, surfels);
    follow(0, seed_, surfels);
    const std::vector<glm::ivec4> links = link_surfels(kernels_, scene_, surfels, pencils_, grid_).pencils.read();
    SeenPoints seen;
    seen.read_points(surfels);
    double lost = 0, reflects = 0;
    std::size_t next = 0;
    for (const SurfacePencil& look : looks.data.read(0, static_cast<std::size_t>(looks.count))) {
        const double before = lost;
        for (const std::size_t end = next + static_cast<std::size_t>(looks.texels()); next < end; ++next) {
            if (!(seen.points()[next].albedo > 0)) continue;
            ++reflects;
            if (links[next].x < 0) ++lost;
        }
        if (lost > before) missed.keys.push_back(look.key);
    }
    missed.share = lost / std::max(reflects, 1.0);
    return missed;
}

/// Surfels from number `first` on that have lobes become what these show.
void WorldSet::follow(int first, uint seed, Surfels& surfels) const {
    if (kernels_.features().lobes) follow_surfels(kernels_, scene_, {lights_, lights_}, first, seed, surfels);
}

/// Puts more pencils where what is seen lies beyond the reach of all: behind edges, in corners and near contacts.
void WorldSet::fill(const Spacing& spacing) {
    std::vector<bool> reached;
    for (const glm::ivec4& link : link_seen().pencils) reached.push_back(link.x >= 0 && link.y != LINK_STANDS_IN);
    PointThinner thinner(widest, alike);
    extend(choose(0, spacing, thinner, reached));
}

/// Which pencils each of the points that are seen reads.
PointLinks WorldSet::link_seen() {
    grid_ = DeviceGrid(kernels_.device(), pencils_on_host());
    const SurfaceLinks found = link_surfels(kernels_, scene_, seen_surfels_, pencils_, grid_);
    return {found.pencils.read(), found.weights.read()};
}

/// The set's, without the seeds.
std::vector<SurfacePencil> WorldSet::pencils_on_host() const { return {seen_.pencils().begin() + seeds_, seen_.pencils().end()}; }

SurfacePencils WorldSet::centres() const {
    SurfacePencils all(kernels_.device(), static_cast<int>(seen_.pencils().size()), world_map);
    all.data.write(seen_.pencils());
    all.count = static_cast<int>(seen_.pencils().size());
    return all;
}

float WorldSet::seen_albedo() const {
    double sum = 0, count = 0;
    for (const SeenPoints::Point& point : seen_.points())
        if (point.albedo > 0) {
            sum += static_cast<double>(point.albedo);
            ++count;
        }
    return static_cast<float>(sum / std::max(count, 1.0));
}

void WorldSet::add_reflected(const Surfels& surfels, const Viewers& viewers, Buffer<float>& radiance) const {
    if (pencils_.count == 0) return;
    Buffer<unsigned char> unused(kernels_.device(), static_cast<std::size_t>(surfels.capacity), "no contacts");
    project_surface_pencils(kernels_, scene_, surfels, pencils_, pencils_.irradiance, grid_, viewers, 0, radiance, unused);
}

double WorldSet::light_to_film() const {
    const std::vector<float>& read = shared_.read_by_film();
    const std::vector<float4> irradiance = pencils_.irradiance.read(0, read.size());
    double light = 0;
    for (std::size_t p = 0; p < read.size(); ++p)
        light += static_cast<double>(read[p]) * static_cast<double>(irradiance[p].x + irradiance[p].y + irradiance[p].z);
    return light;
}

void WorldSet::gather(int map, std::uint64_t seed) {
    const int draws = map * map / (share_map * share_map);
    ChosenSurfels chosen;
    for (std::size_t p = 0; p < sources_.size(); ++p)
        for (const int drawn : shared_.draw(p, draws, seed)) {
            const int point = drawn >= 0 ? drawn : sources_[p];
            chosen.add(point, seen_.pencils()[static_cast<std::size_t>(seeds_) + p].key, seen_.viewer(static_cast<std::size_t>(point)));
        }
    map_ = map;
    points_ = {static_cast<uint>(hash64(seed) >> 32)};
    starts_ = SurfacePencils(kernels_.device(), 1, share_map);
    place_surface_pencils(kernels_, seen_surfels_, chosen, starts_);
    const int texels = pencils_.count * map * map;
    if (surfels_.capacity < texels) surfels_ = Surfels(kernels_, texels, "surfels of the world set");
    trace_hemispheres(kernels_, scene_, starts_, 0, starts_.count, points_, surfels_, 0, map);
    follow(0, static_cast<uint>(hash64(seed + 1) >> 32), surfels_);
    links_ = link_surfels(kernels_, scene_, surfels_, pencils_, grid_);
}

/// Points from number `first` on, but for those to skip and what reflects nothing, with their spacings: close ones first, so that no wide
/// pencil lies where close ones do, and otherwise so that neighbours come far apart.
std::vector<WorldSet::SpacedPoint> WorldSet::by_spacing(int first, float width, const std::vector<bool>& skip) const {
    const std::size_t begin = static_cast<std::size_t>(first), size = seen_.points().size() - begin;
    const std::size_t stride = size % visit_stride == 0 ? 1 : visit_stride;
    std::vector<std::vector<SpacedPoint>> octaves(most_octaves);
    for (std::size_t k = 0, i = 0; k < size; ++k, i = (i + stride) % size) {
        const SeenPoints::Point& point = seen_.points()[begin + i];
        if (!(point.albedo > 0) || (!skip.empty() && skip[i])) continue;
        const float distance = glm::distance(point.position, seen_.viewer(begin + i)),
                    own = std::min(std::max(glm::clamp(distance, near_spacing * width, width), far_spacing * distance), widest);
        if (!(own > 0)) continue;
        const int octave = own <= width ? 0 : std::min(std::ilogb(own / width) + 1, most_octaves - 1);
        octaves[static_cast<std::size_t>(octave)].push_back({own, begin + i});
    }
    std::vector<SpacedPoint> points;
    points.reserve(size);
    for (const std::vector<SpacedPoint>& octave : octaves) points.insert(points.end(), octave.begin(), octave.end());
    return points;
}

/// A spacing that keeps about `count` of the points, if there are as many.
float WorldSet::spacing_for(std::size_t count, float guess) {
    double inverse = 0;
    std::vector<float> distances;
    for (std::size_t i = 0; i < seen_.points().size(); ++i) {
        if (!(seen_.points()[i].albedo > 0)) continue;
        distances.push_back(glm::distance(seen_.points()[i].position, seen_.viewer(i)));
        inverse += 1.0 / std::max(distances.back(), 1e-30F);
    }
    const float middle = static_cast<float>(static_cast<double>(seen_.points().size()) / std::max(inverse, 1e-30));
    seen_distance_ = distances.empty() ? middle : median_of(distances);
    float spacing = std::min(guess > 0 ? std::max(guess, least_guess * middle) : first_guess * middle, widest);
    for (int k = 0; k < most_guesses; ++k) {
        PointThinner thinner(widest, alike);
        const double kept = static_cast<double>(choose(0, {spacing, 4 * count}, thinner).surfels.size());
        const double factor = std::sqrt(kept / static_cast<double>(count));
        if (std::abs(factor - 1.0) < guess_tolerance) break;
        spacing = std::max(spacing * static_cast<float>(std::clamp(factor, 1.0 / most_step, most_step)), least_guess * middle);
    }
    return std::min(spacing, widest);  // almost nothing that is seen may reflect
}

/// Surfels that are seen, from number `first` on that the thinner keeps: closer ones near viewers, wider ones if there
/// are too many.
ChosenSurfels WorldSet::choose(int first, Spacing spacing, PointThinner& thinner, const std::vector<bool>& skip) const {
    for (;;) {
        PointThinner kept = thinner;
        ChosenSurfels chosen;
        const std::vector<SpacedPoint> points = by_spacing(first, spacing.width, skip);
        std::size_t looked = 0;
        for (const auto& [own, i] : points) {
            if (chosen.surfels.size() > spacing.most) break;
            ++looked;
            const SeenPoints::Point& point = seen_.points()[i];
            if (kept.add(point.position, point.normal, own))
                chosen.add(static_cast<int>(i), static_cast<uint>(pencils_.count) + static_cast<uint>(chosen.surfels.size()),
                           seen_.viewer(i), reach * own);
        }
        if (chosen.surfels.size() <= spacing.most || spacing.width >= widest) {
            thinner = std::move(kept);
            return chosen;
        }
        spacing.width *= std::max(step_coarser, std::sqrt(static_cast<float>(points.size()) / static_cast<float>(looked)) * 0.8F);
    }
}

/// Places pencils on chosen surfels and traces them.
void WorldSet::extend(const ChosenSurfels& chosen) {
    const int first = pencils_.count, count = static_cast<int>(chosen.surfels.size()), texels = pencils_.texels();
    if (count == 0) return;
    sources_.insert(sources_.end(), chosen.surfels.begin(), chosen.surfels.end());
    place_surface_pencils(kernels_, seen_surfels_, chosen, pencils_);
    seen_surfels_.reserve(kernels_.device(), count * texels, seen_name);
    const int at = (seeds_ + first) * texels;
    trace_hemispheres(kernels_, scene_, pencils_, first, count, {seed_}, seen_surfels_, at);
    measure_hemispheres(kernels_, seen_surfels_, at, first, count, pencils_);
    follow(at, seed_, seen_surfels_);
    seen_.read_pencils(pencils_);
    seen_.read_points(seen_surfels_);
}

}  // namespace pencil
