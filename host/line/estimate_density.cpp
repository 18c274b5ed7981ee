#include "line/estimate_density.h"

namespace pencil {

void estimate_density(Kernels& kernels, const Surfels& surfels, const Buffer<uint>& mask, int first, PencilSet& set) {
    kernels.get("estimate_density")
        .args(surfels.data, surfels.capacity, surfels.count, set.maps->cops, set.maps->count, mask, first, set.maps->n, set.radiance)
        .run(kernels.packets(surfels.count), "pencil density");
}

}  // namespace pencil
