#include "line/estimate_density.h"

namespace pencil {

void estimate_density(Kernels& kernels, const Surfels& surfels, const Buffer<uint>& mask, int first, PencilSet& set) {
    kernels.get("estimate_density")
        .args(surfels.list(), set.maps->centres(), mask, first, set.maps->n, set.radiance)
        .run(kernels.packets(surfels.count), "pencil density");
}

}  // namespace pencil
