#include "visibility/rasterize_clusters.h"

#include "visibility/fold_hits.h"

namespace pencil {

void rasterize_clusters(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count) {
    kernels.get("rasterize_clusters")
        .args(scene.all_triangles(), scene.clusters, scene.cluster_count, scene.members, maps.tiles(first, count), maps.hits)
        .run(static_cast<std::size_t>(PENCIL_MAP_FACETS(maps.shape.kind)) * static_cast<std::size_t>(count), "rasterize clusters");
    fold_hits(kernels, scene, maps, first, count);
}

}  // namespace pencil
