#include "visibility/fold_hits.h"

namespace pencil {

void fold_hits(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count) {
    kernels.get("fold_hits")
        .args(scene.faces(), maps.tiles(first, count), maps.hits, maps.cells, maps.groups)
        .run(static_cast<std::size_t>(count) * static_cast<std::size_t>(maps.stored()), "fold geometry maps");
}

}  // namespace pencil
