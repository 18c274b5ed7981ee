#include "surface/follow_surfels.h"

namespace pencil {

void follow_surfels(Kernels& kernels, const DeviceScene& scene, const ChainLights& lights, int first, uint seed, Surfels& surfels,
                    const std::optional<Viewers>& viewers) {
    const ViewerArguments seen_by(kernels.device(), viewers);
    const int count = surfels.count - first;
    const Buffer<int> no_list(kernels.device(), 1, "no list of chains");
    const Buffer<float> unused(kernels.device(), 1, "no chains of the film");
    kernels.get("follow_surfels")
        .args(surfels.store(), no_list, 0, 0, 0, count, seen_by.list(), lights.list(), seed, scene.hierarchy(), scene.surfaces(),
              surfels.store(), first, unused)
        .run(kernels.packets(count), "follow lobes");
}

Chains follow_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& from, const Buffer<int>& starts, const FilmChains& film,
                      const ChainLights& lights, uint seed) {
    const int count = static_cast<int>(starts.size());
    const ViewerArguments nobody(kernels.device(), {});
    Chains chains{Surfels(kernels, count, "ends of chains"), Buffer<float>(kernels.device(), starts.size(), "chains beside even light")};
    kernels.get("follow_surfels")
        .args(from.store(), starts, 1, film.chains, static_cast<int>(film.balanced), count, nobody.list(), lights.list(), seed,
              scene.hierarchy(), scene.surfaces(), chains.ends.store(), 0, chains.uneven)
        .run(kernels.packets(count), "follow lobes");
    return chains;
}

}  // namespace pencil
