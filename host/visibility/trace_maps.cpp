#include "visibility/trace_maps.h"

#include "visibility/fold_hits.h"

namespace pencil {

void trace_maps(Kernels& kernels, const DeviceScene& scene, GeometryMaps& maps, int first, int count) {
    kernels.get("trace_maps")
        .args(scene.hierarchy(), scene.faces(), maps.tiles(first, count), maps.hits)
        .run(kernels.packets(count * maps.texels()), "trace geometry maps");
    fold_hits(kernels, scene, maps, first, count);
}

}  // namespace pencil
