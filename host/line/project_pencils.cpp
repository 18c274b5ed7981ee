#include "line/project_pencils.h"

namespace pencil {

void project_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const PencilSet& set, WeightTables& weights,
                     Buffer<float>& outgoing, Buffer<int>& visible, const std::string& what) {
    // Cells take up to 1.3 MB of a work-item's private memory, and CPU drivers keep that of a whole group on the stack.
    const bool alone = kernels.features().weights == PENCIL_WEIGHTS_VORONOI && kernels.device()->info().is_cpu;
    const CellTable& table = weights.cells(set.maps->count);
    kernels.get("project_pencils")
        .args(surfels.list(), set.maps->centres(), set.radiance, visibility_map(*set.maps, scene), table.list(), outgoing, 1, visible)
        .run(kernels.blocks(surfels.count), what, alone ? 1 : 0);
}

}  // namespace pencil
