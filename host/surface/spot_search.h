// Search for bright spots and portals among what a world set sees.
#pragma once

#include "surface/gatherer.h"
#include "surface/spots.h"
#include "surface/world_set.h"

namespace pencil {

class SpotSearch {
public:
    /// All must outlive it.
    SpotSearch(Kernels& kernels, const DeviceScene& scene, const SurfaceLights& lights, const WorldSet& world, Gatherer& gatherer)
        : kernels_(kernels), scene_(scene), lights_(lights), world_(world), gatherer_(gatherer) {}

    /// Before the set gathers, by other rays than its own, so that what is found serves the first gather, too: places close before lights, and
    /// portals of light that comes from lights by one reflection at most. Beside spots `known`.
    std::vector<Spot> ahead(const std::vector<Spot>& known, std::uint64_t seed);
    /// Places among what the set's texels see that send `outgoing` [3][capacity], and those of ahead().
    std::vector<Spot> among_seen(const Buffer<float>& outgoing) const;

private:
    std::vector<Spot> near_lights(std::uint64_t seed);
    std::vector<Spot> portals(const std::vector<Spot>& known, std::uint64_t seed);

    Kernels& kernels_;
    const DeviceScene& scene_;
    const SurfaceLights& lights_;
    const WorldSet& world_;
    Gatherer& gatherer_;
    std::vector<Spot> ahead_;
};

}  // namespace pencil
