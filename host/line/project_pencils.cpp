#include "line/project_pencils.h"

namespace pencil {

void project_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const PencilSet& set, WeightTables& weights,
                     Buffer<float>& outgoing, Buffer<int>& visible, const std::string& what) {
    const CellTable& table = weights.cells(set.maps->count);
    kernels.get("project_pencils")
        .args(surfels.data, surfels.capacity, surfels.count, set.maps->cops, set.maps->count, set.radiance, set.maps->cells,
              set.maps->groups, set.maps->hits, scene.triangles, scene.planes, set.maps->n, table.directions, table.tiles, outgoing, 1,
              visible)
        .run(kernels.blocks(surfels.count), what);
}

}  // namespace pencil
