#include "visibility/rasterize_octahedral.h"

#include "visibility/fold_hits.h"

namespace pencil {

void rasterize_octahedral(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count) {
    kernels.get("rasterize_octahedral")
        .args(scene.all_triangles(), maps.tiles(first, count), maps.hits)
        .run(8 * static_cast<std::size_t>(count), "rasterize octahedral maps");
    fold_hits(kernels, scene, maps, first, count);
}

}  // namespace pencil
