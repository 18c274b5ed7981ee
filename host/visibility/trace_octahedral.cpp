#include "visibility/trace_octahedral.h"

#include "visibility/fold_hits.h"

namespace pencil {

void trace_octahedral(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count) {
    kernels.get("trace_octahedral")
        .args(scene.hierarchy(), scene.faces(), maps.tiles(first, count), maps.hits)
        .run(kernels.packets(count * maps.n * maps.n), "trace octahedral maps");
    fold_hits(kernels, scene, maps, first, count);
}

}  // namespace pencil
