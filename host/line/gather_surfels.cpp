#include "line/gather_surfels.h"

namespace pencil {

void gather_surfels(Kernels& kernels, const DeviceScene& scene, const GeometryMaps& maps, int first, int count, Surfels& surfels) {
    surfels.count = count * maps.texels();
    kernels.get("gather_surfels")
        .args(maps.hits, maps.tiles(first, count), scene.surfaces(), surfels.store())
        .run(static_cast<std::size_t>(surfels.count), "gather surfels");
}

}  // namespace pencil
