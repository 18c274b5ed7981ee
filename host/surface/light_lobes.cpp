#include "surface/light_lobes.h"

namespace pencil {

void light_lobes(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const Buffer<int>& chosen, int chains,
                 const LightSet& lights, Buffer<float>& outgoing) {
    const int count = static_cast<int>(chosen.size());
    kernels.get("light_lobes")
        .args(surfels.store(), chosen, count, chains, lights.list(), scene.hierarchy(), scene.surfaces(), outgoing)
        .run(kernels.packets(count), "direct light on lobes");
}

}  // namespace pencil
