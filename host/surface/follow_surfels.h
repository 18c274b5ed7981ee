// Launcher of kernels/follow_surfels.cl.
#pragma once

#include "device/device_scene.h"
#include "device/features.h"
#include "device/surfels.h"
#include "surface/viewers.h"

namespace pencil {

/// Light samples that reach vertices of chains: their near_areas, and how many are the sky's, a share of one where only some are drawn.
struct LobeLights {
    Buffer<float> near;
    float sky = 0;
};

/// Those of the first vertex and of all others.
struct ChainLights {
    const LobeLights& first;
    const LobeLights& next;
    auto list() const { return std::tie(first.near, next.near, first.sky, next.sky); }
};

/// Where chains that start on the film end, with what they carry, and what each counts beside even light (follow_surfels.cl).
struct Chains {
    Surfels ends;
    Buffer<float> uneven;
};

/// Surfels from number `first` on that have lobes become what chains along these end on, or stop where they are. `viewers`: who sees them, so
/// that where chains go does not depend on what else is followed at once.
void follow_surfels(Kernels& kernels, const DeviceScene& scene, const ChainLights& lights, int first, uint seed, Surfels& surfels,
                    const std::optional<Viewers>& viewers = {});

/// Chains of each surfel of the film.
struct FilmChains {
    int chains;
    bool balanced;  // light samples on its lobes know how many (light_lobes)
};

/// Chains that all take a first step from surfels `starts` of `from`, of which `film.chains` one after the other are the same: their first steps are
/// spread over its lobes, and over what its base scatters otherwise than evenly.
Chains follow_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& from, const Buffer<int>& starts, const FilmChains& film,
                      const ChainLights& lights, uint seed);

}  // namespace pencil
