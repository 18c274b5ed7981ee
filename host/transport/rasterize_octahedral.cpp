#include "transport/rasterize_octahedral.h"

namespace pencil {

void rasterize_octahedral(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count) {
    kernels.get("rasterize_octahedral")
        .args(scene.triangles, scene.triangle_count, scene.planes, maps.cops, first, count, maps.n, maps.hits)
        .run(8 * static_cast<std::size_t>(count), "rasterize octahedral maps", 1);
    kernels.get("fold_hits")
        .args(scene.triangles, scene.planes, maps.cops, first, count, maps.n, maps.hits, maps.cells, maps.groups)
        .run(static_cast<std::size_t>(count) * static_cast<std::size_t>(PENCIL_TILE_TEXELS(maps.n)), "fold geometry maps");
}

}  // namespace pencil
