#include "surface/world_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pencil {

namespace {

/// Pencils further apart than this in their normals do not stand for each other (REUSE_LEAST_COSINE is the looser bound of use).
constexpr float alike = 0.7F;
/// A pencil is used up to this many spacings away.
constexpr float reach = 1.4F;
constexpr int most_rounds = 8;
/// The world set has at most this many times the pencils asked for: small things in large rooms need more.
constexpr int most_per_wish = 6;
/// Width of the maps: they are read through the maps of film pencils only.
constexpr int world_map = 8;
/// Spacing of the pencils that fill what none reaches, relative to the others.
constexpr float fill_spacing = 0.25F;
/// Things seen from nearer than the spacing get closer pencils, but not closer than this share of it: light changes fast near contacts.
constexpr float near_spacing = 0.5F;

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
      spacing_(static_cast<float>(std::sqrt(0.7 * surface_area(flat) / wish))),
      pencils_(kernels.device(), wish, world_map),
      surfels_(kernels.device(), wish * world_map * world_map, "surfels of the world set") {
    surfels_.count = 0;
}

void WorldSet::cover(const SurfacePencils& seeds) {
    Surfels seen(kernels_.device(), seeds.count * seeds.texels(), "surfels of the seeds");
    trace_hemispheres(kernels_, scene_, seeds, 0, seeds.count, {seed_}, seen);
    PointThinner thinner(spacing_, alike);
    int first = extend(seen, choose(seen, 0, {}, seeds, thinner));
    for (int round = 1; round < most_rounds && first < pencils_.count; ++round)
        first = extend(surfels_, choose(surfels_, first * pencils_.texels(), {}, pencils_, thinner));
    grid_ = DeviceGrid(kernels_.device(), pencils_, flat_);
    links_ = link_surfels(kernels_, surfels_, pencils_, grid_);
    PointThinner finer(fill_spacing * spacing_, alike);
    int added = fill(surfels_, links_, pencils_, finer);
    added += fill(seen, link_surfels(kernels_, seen, pencils_, grid_), seeds, finer);
    if (added == 0) return;
    grid_ = DeviceGrid(kernels_.device(), pencils_, flat_);
    links_ = link_surfels(kernels_, surfels_, pencils_, grid_);
}

/// Surfels from number `first` on, seen by `viewers`, but for those to skip, that the thinner keeps at its spacing, or closer near viewers.
ChosenSurfels WorldSet::choose(const Surfels& surfels, int first, const std::vector<bool>& skip, const SurfacePencils& viewers,
                               PointThinner& thinner) const {
    const auto size = static_cast<std::size_t>(surfels.count - first);
    const auto field = [&](int f) {
        return surfels.data.read(static_cast<std::size_t>(f) * static_cast<std::size_t>(surfels.capacity) + static_cast<std::size_t>(first),
                                 size);
    };
    const std::vector<float> x = field(SURFEL_X), y = field(SURFEL_Y), z = field(SURFEL_Z), nx = field(SURFEL_NX), ny = field(SURFEL_NY),
                             nz = field(SURFEL_NZ);
    const std::vector<SurfacePencil> from = viewers.data.read(0, static_cast<std::size_t>(viewers.count));
    ChosenSurfels chosen;
    const int most = most_per_wish * wish_ - pencils_.count;
    const std::size_t stride = size % 7919 == 0 ? 1 : 7919;  // a prime: all are visited, neighbours far apart
    for (std::size_t k = 0, i = 0; k < size && static_cast<int>(chosen.surfels.size()) < most; ++k, i = (i + stride) % size) {
        const glm::vec3 n(nx[i], ny[i], nz[i]);
        if (n == glm::vec3(0) || (!skip.empty() && skip[i])) continue;
        const int surfel = first + static_cast<int>(i);
        const glm::vec3 p(x[i], y[i], z[i]);
        const glm::vec3 viewer(from[static_cast<std::size_t>(surfel / viewers.texels())].position);
        const float own = glm::clamp(glm::distance(p, viewer), near_spacing * thinner.most(), thinner.most());
        if (!thinner.add(p, n, own)) continue;
        chosen.add(surfel, static_cast<uint>(pencils_.count) + static_cast<uint>(chosen.surfels.size()), viewer, reach * own);
    }
    return chosen;
}

/// Places pencils on chosen surfels and traces them; the number of the first.
int WorldSet::extend(const Surfels& surfels, const ChosenSurfels& chosen) {
    const int first = pencils_.count, count = static_cast<int>(chosen.surfels.size()), texels = pencils_.texels();
    if (count == 0) return first;
    place_surface_pencils(kernels_, surfels, chosen, pencils_);
    surfels_.reserve(kernels_.device(), count * texels, "surfels of the world set");
    trace_hemispheres(kernels_, scene_, pencils_, first, count, {seed_}, surfels_, first * texels);
    measure_hemispheres(kernels_, surfels_, first * texels, first, count, pencils_);
    return first;
}

/// Pencils on surfels that none reaches by their links; how many.
int WorldSet::fill(const Surfels& surfels, const SurfaceLinks& links, const SurfacePencils& viewers, PointThinner& thinner) {
    std::vector<bool> reached;
    for (const glm::ivec4& link : links.pencils.read()) reached.push_back(link.x >= 0 && link.y != LINK_LAST_RESORT);
    const int before = pencils_.count;
    extend(surfels, choose(surfels, 0, reached, viewers, thinner));
    return pencils_.count - before;
}

}  // namespace pencil
