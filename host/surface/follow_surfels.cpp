#include "surface/follow_surfels.h"

namespace pencil {

void follow_surfels(Kernels& kernels, const DeviceScene& scene, const ChainLights& lights, int first, uint seed, Surfels& surfels) {
    const int count = surfels.count - first;
    const Buffer<int> no_list(kernels.device(), 1, "no list of chains");
    kernels.get("follow_surfels")
        .args(surfels.store(), no_list, 0, 0, count, lights.list(), seed, scene.hierarchy(), scene.surfaces(), surfels.store(), first)
        .run(kernels.packets(count), "follow lobes");
}

void follow_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& from, const Buffer<int>& starts, int shared,
                    const ChainLights& lights, uint seed, Surfels& surfels) {
    const int count = static_cast<int>(starts.size());
    kernels.get("follow_surfels")
        .args(from.store(), starts, 1, shared, count, lights.list(), seed, scene.hierarchy(), scene.surfaces(), surfels.store(), 0)
        .run(kernels.packets(count), "follow lobes");
}

}  // namespace pencil
