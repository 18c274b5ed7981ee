#include "surface/sum_hemispheres.h"

namespace pencil {

void sum_hemispheres(Kernels& kernels, const Buffer<float>& radiance, int capacity, int first_surfel, int first, int count, int n,
                     Buffer<float4>& irradiance) {
    kernels.get("sum_hemispheres")
        .args(radiance, capacity, first_surfel, first, count, n, irradiance)
        .run(static_cast<std::size_t>(count), "sum hemispheres", pencil_group);
}

}  // namespace pencil
