#include "line/expand_maps.h"

namespace pencil {

void expand_maps(Kernels& kernels, const DeviceScene& scene, const PencilSet& coarse, MapPart part, PencilSet& set) {
    const GeometryMaps& maps = *set.maps;
    kernels.get("expand_maps")
        .args(coarse.radiance, coarse.maps->hits, coarse.maps->n, maps.hits, scene.triangles, 0, maps.count, maps.n,
              part == MapPart::light ? 0 : 1, set.radiance)
        .run(kernels.packets(maps.count * maps.stored()), "expand maps");
}

}  // namespace pencil
