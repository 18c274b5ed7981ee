#include "line/test_visibility.h"

namespace pencil {

void test_visibility(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const GeometryMaps& maps, Buffer<uint>& mask) {
    kernels.get("test_visibility")
        .args(surfels.list(), maps.centres(), visibility_map(maps, scene), mask)
        .run(kernels.blocks(surfels.count), "visibility masks");
}

}  // namespace pencil
