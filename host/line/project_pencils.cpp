#include "line/project_pencils.h"

namespace pencil {

void project_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, int first, int end, const PencilSet& set,
                     WeightTables& weights, Buffer<float>& outgoing, Buffer<int>& visible, const std::string& what) {
    // Cells take up to 1.3 MB of a work-item's private memory, and CPU drivers keep that of a whole group on the stack.
    const bool alone = weights_are_cells(kernels.features().weights) && kernels.device()->info().is_cpu;
    const CellTable& table = weights.cells(set.maps->count + weights.rays().count);
    const auto project = [&](const auto& radiance) {
        kernels.get("project_pencils")
            .args(surfels.store(), first, end, set.maps->centres(), radiance, visibility_map(*set.maps, scene), table.list(),
                  weights.rays().list(), outgoing, 1, visible)
            .run(kernels.blocks(end - first), what, alone ? 1 : 0);
    };
    if (kernels.features().atlas_image)
        project(weights.atlas().image_of(set));
    else
        project(set.radiance);
}

void project_pencils(Kernels& kernels, const DeviceScene& scene, const Surfels& surfels, const PencilSet& set, WeightTables& weights,
                     Buffer<float>& outgoing, Buffer<int>& visible, const std::string& what) {
    project_pencils(kernels, scene, surfels, 0, surfels.count, set, weights, outgoing, visible, what);
}

}  // namespace pencil
