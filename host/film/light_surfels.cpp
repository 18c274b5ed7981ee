#include "film/light_surfels.h"

namespace pencil {

void light_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, Buffer<float>& outgoing,
                   const std::string& what) {
    kernels.get("light_surfels")
        .args(surfels.list(), lights.list(), lights.maps.cops, std::tie(lights.maps.cells, lights.maps.groups, lights.maps.hits),
              scene.surfaces(), lights.maps.n, scene.hierarchy(), outgoing, 1)
        .run(kernels.blocks(surfels.count), what);
}

}  // namespace pencil
