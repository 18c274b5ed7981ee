#include "surface/world_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "surface/measure_hemispheres.h"

namespace pencil {

namespace {

// Chosen by trial for the least error at equal time (docs/accuracy.md) where no other reason is given.

/// Pencils further apart than this in their normals do not stand for each other (REUSE_LEAST_COSINE is the looser bound of use).
constexpr float alike = 0.7F;
/// A pencil is used up to this many spacings away.
constexpr float reach = 1.4F;
/// Rounds of pencils on what the last round sees: light goes round corners in that many steps at most until the fill.
constexpr int most_rounds = 8;
/// The world set has at most this many times the pencils asked for: small things in large rooms need more.
constexpr int most_per_wish = 6;
/// Width of the maps: they are read through the maps of film pencils only.
constexpr int world_map = 8;
/// Spacing of the pencils that fill what none reaches, relative to the others.
constexpr float fill_spacing = 0.25F;
/// Things seen from nearer than the spacing get closer pencils, but not closer than this share of it: light changes fast near contacts.
constexpr float near_spacing = 0.5F;
/// Step of the order in which surfels are visited: a prime, so that all are, and so far that neighbours come far apart.
constexpr std::size_t visit_stride = 7919;
/// Points that dart throwing keeps in a square as wide as the spacing: discs of that diameter jam at a coverage of 0.547 (Feder 1980),
/// and 0.547 * 4 / pi = 0.7.
constexpr double darts_per_square = 0.7;

double surface_area(const FlatScene& flat) {
    return std::accumulate(flat.triangles.begin(), flat.triangles.end(), 0.0,
                           [](double sum, const Triangle& t) { return sum + glm::length(area_vector(t)); });
}

}  // namespace

WorldSet::WorldSet(Kernels& kernels, const DeviceScene& scene, const FlatScene& flat, int wish, uint seed)
    : kernels_(kernels),
      scene_(scene),
      flat_(flat),
      wish_(wish),
      seed_(seed),
      spacing_(static_cast<float>(std::sqrt(darts_per_square * surface_area(flat) / wish))),
      pencils_(kernels.device(), wish, world_map),
      surfels_(kernels, wish * world_map * world_map, "surfels of the world set") {
    surfels_.count = 0;
}

void WorldSet::cover(const SurfacePencils& seeds) {
    Surfels first_seen(kernels_, seeds.count * seeds.texels(), "surfels of the seeds");
    trace_hemispheres(kernels_, scene_, seeds, 0, seeds.count, {seed_}, first_seen);
    SeenPoints by_seeds;
    by_seeds.read_pencils(seeds);
    by_seeds.read_points(first_seen);
    PointThinner thinner(spacing_, alike);
    int first = extend(first_seen, choose(by_seeds, 0, {}, thinner));
    for (int round = 1; round < most_rounds && first < pencils_.count; ++round) {
        seen_.read_points(surfels_);
        first = extend(surfels_, choose(seen_, first * pencils_.texels(), {}, thinner));
    }
    seen_.read_points(surfels_);
    link();
    PointThinner finer(fill_spacing * spacing_, alike);
    int added = fill(surfels_, seen_, links_, finer);
    added += fill(first_seen, by_seeds, link_surfels(kernels_, first_seen, pencils_, grid_), finer);
    if (added > 0) link();
}

/// The grid of the pencils so far, and which of them stand for what they see.
void WorldSet::link() {
    grid_ = DeviceGrid(kernels_.device(), seen_.pencils(), flat_);
    links_ = link_surfels(kernels_, surfels_, pencils_, grid_);
}

/// Surfels that are seen, from number `first` on, but for those to skip, that the thinner keeps at its spacing, or closer near viewers.
ChosenSurfels WorldSet::choose(const SeenPoints& seen, int first, const std::vector<bool>& skip, PointThinner& thinner) const {
    const std::size_t begin = static_cast<std::size_t>(first), size = seen.points().size() - begin;
    const std::size_t stride = size % visit_stride == 0 ? 1 : visit_stride;
    ChosenSurfels chosen;
    const int most = most_per_wish * wish_ - pencils_.count;
    for (std::size_t k = 0, i = 0; k < size && static_cast<int>(chosen.surfels.size()) < most; ++k, i = (i + stride) % size) {
        const auto& [p, n] = seen.points()[begin + i];
        if (n == glm::vec3(0) || (!skip.empty() && skip[i])) continue;
        const glm::vec3 viewer = seen.viewer(begin + i);
        const float own = glm::clamp(glm::distance(p, viewer), near_spacing * thinner.most(), thinner.most());
        if (!thinner.add(p, n, own)) continue;
        chosen.add(first + static_cast<int>(i), static_cast<uint>(pencils_.count) + static_cast<uint>(chosen.surfels.size()), viewer,
                   reach * own);
    }
    return chosen;
}

/// Places pencils on chosen surfels and traces them; the number of the first.
int WorldSet::extend(const Surfels& surfels, const ChosenSurfels& chosen) {
    const int first = pencils_.count, count = static_cast<int>(chosen.surfels.size()), texels = pencils_.texels();
    if (count == 0) return first;
    place_surface_pencils(kernels_, surfels, chosen, pencils_);
    seen_.read_pencils(pencils_);
    surfels_.reserve(kernels_.device(), count * texels, "surfels of the world set");
    trace_hemispheres(kernels_, scene_, pencils_, first, count, {seed_}, surfels_, first * texels);
    measure_hemispheres(kernels_, surfels_, first * texels, first, count, pencils_);
    return first;
}

/// Pencils on surfels that none reaches by their links; how many.
int WorldSet::fill(const Surfels& surfels, const SeenPoints& seen, const SurfaceLinks& links, PointThinner& thinner) {
    std::vector<bool> reached;
    for (const glm::ivec4& link : links.pencils.read()) reached.push_back(link.x >= 0 && link.y != LINK_LAST_RESORT);
    const int before = pencils_.count;
    extend(surfels, choose(seen, 0, reached, thinner));
    return pencils_.count - before;
}

}  // namespace pencil
