#include "line/test_visibility.h"

namespace pencil {

void test_visibility(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const GeometryMaps& maps, Buffer<uint>& mask) {
    kernels.get("test_visibility")
        .args(surfels.data, surfels.capacity, surfels.count, maps.cops, maps.count, maps.cells, maps.groups, maps.hits, scene.triangles,
              scene.planes, maps.n, mask)
        .run(kernels.blocks(surfels.count), "visibility masks");
}

}  // namespace pencil
