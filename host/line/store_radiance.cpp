#include "line/store_radiance.h"

namespace pencil {

void store_radiance(Kernels& kernels, const Surfels& surfels, const Buffer<float>& outgoing, int first, int count, PencilSet& set) {
    const int n = set.maps->n;
    kernels.get("store_radiance")
        .args(outgoing, surfels.capacity, first, count, n, set.radiance)
        .run(static_cast<std::size_t>(count) * static_cast<std::size_t>(set.maps->texels()), "store radiance");
    const std::size_t texels = static_cast<std::size_t>(set.maps->stored()), all = static_cast<std::size_t>(count) * texels;
    Buffer<float4> sharp(kernels.device(), all, "radiance before smoothing");
    sharp.copy_from(set.radiance, static_cast<std::size_t>(first) * texels, 0, all);
    kernels.get("smooth_radiance").args(sharp, first, count, n, set.radiance).run(all, "smooth radiance maps");
}

}  // namespace pencil
