#include "line/gather_surfels.h"

namespace pencil {

void gather_surfels(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps, int first, int count, Surfels& surfels) {
    surfels.count = count * maps.n * maps.n;
    kernels.get("gather_surfels")
        .args(maps.hits, maps.cops, first, count, maps.n, scene.triangles, scene.planes, scene.materials, scene.normals, surfels.data,
              surfels.capacity)
        .run(static_cast<std::size_t>(surfels.count), "gather surfels");
}

}  // namespace pencil
