#include "film/light_surfels.h"

namespace pencil {

void light_surfels(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const LightSet& lights, Buffer<float>& outgoing,
                   const std::string& what) {
    kernels.get("light_surfels")
        .args(surfels.data, surfels.capacity, surfels.count, lights.samples, lights.maps.count, lights.maps.cops, lights.maps.cells,
              lights.maps.groups, lights.maps.hits, scene.triangles, scene.planes, lights.maps.n, scene.nodes, scene.leaves, outgoing, 1)
        .run(kernels.blocks(surfels.count), what);
}

}  // namespace pencil
