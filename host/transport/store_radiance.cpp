#include "transport/store_radiance.h"

namespace pencil {

void store_radiance(Kernels& kernels, const Surfels& surfels, const Buffer<float>& outgoing, int first, int count, PencilSet& set) {
    const int n = set.maps->n;
    kernels.get("store_radiance", {"octahedral"})
        .args(outgoing, surfels.capacity, first, count, n, set.radiance)
        .run(static_cast<std::size_t>(count) * static_cast<std::size_t>(n * n), "store radiance");
    kernels.get("fold_radiance", {"octahedral"})
        .args(first, count, n, set.radiance)
        .run(static_cast<std::size_t>(count) * static_cast<std::size_t>(4 * (n + 1)), "fold radiance maps");
}

}  // namespace pencil
