#include "surface/spot_search.h"

#include <algorithm>

#include "surface/emit_hemispheres.h"
#include "surface/near_lights.h"
#include "surface/portals.h"

namespace pencil {

namespace {

// In terms of the distance from which things are seen:
/// Bright points so far apart may be one spot: wide cones cost little where light is concentrated, and hold what is bright about it.
constexpr float spot_reach = 0.4F;
/// What a light lights as far away from it may be too small for texels.
constexpr float near_reach = 0.25F;
/// The widest portal.
constexpr float portal_reach = 0.4F;

/// Where what is seen reflects more, rays that leave through a portal and rays that go on have to add up to all of them, which those of texels alone
/// do.
constexpr float most_albedo = 0.95F;

}  // namespace

std::vector<Spot> SpotSearch::ahead(const std::vector<Spot>& known, std::uint64_t seed) {
    ahead_ = near_lights(seed);
    std::vector<Spot> all = known;
    all.insert(all.end(), ahead_.begin(), ahead_.end());
    const std::vector<Spot> found = portals(all, seed);
    ahead_.insert(ahead_.end(), found.begin(), found.end());
    return ahead_;
}

std::vector<Spot> SpotSearch::among_seen(const Buffer<float>& outgoing) const {
    std::vector<Spot> spots = ahead_;
    const auto is_known = [&](const Spot& found) {
        return std::any_of(spots.begin(), spots.end(), [&](const Spot& s) { return holds(s, found.centre); });
    };
    std::vector<Spot> found = find_spots(world_.surfels(), outgoing, spot_reach * world_.seen_distance());
    found.erase(std::remove_if(found.begin(), found.end(), is_known), found.end());
    spots.insert(spots.end(), found.begin(), found.end());
    return spots;
}

/// Among what pencils see from their centres.
std::vector<Spot> SpotSearch::portals(const std::vector<Spot>& known, std::uint64_t seed) {
    const Surfels& seen = world_.seen_from_centres();
    if (seen.count == 0 || world_.seen_albedo() > most_albedo) return {};
    const SurfacePencils centres = world_.centres();
    Buffer<float> radiance = surfel_rgb(kernels_.device(), seen.capacity, "light to centres");
    emit_hemispheres(kernels_, scene_, seen, {centres, 0}, lights_.near_texel, radiance);
    const std::vector<float> emission = light_of(seen, radiance);
    gatherer_.light(seen, radiance, seed);
    return find_portals(light_rays(world_.seen_points(), seen, kernels_.features().outgoing(), emission, light_of(seen, radiance)),
                        centres.texels(), {world_.seen_distance(), portal_reach * world_.seen_distance()}, known);
}

/// Where lights stand too close before surfaces for texels to find what they light.
std::vector<Spot> SpotSearch::near_lights(std::uint64_t seed) {
    if (lights_.small.empty()) return {};
    const SurfacePencils probes = probes_of(kernels_.device(), lights_.small);
    Gathered met;
    gatherer_.reserve(met, probes.count * probes.texels());
    trace_hemispheres(kernels_, scene_, probes, 0, probes.count, {}, met.surfels);
    gatherer_.light(met.surfels, met.outgoing, seed);
    return near_light_spots(lights_.small, met.surfels, met.outgoing, near_reach * world_.seen_distance(), lights_.power);
}

}  // namespace pencil
