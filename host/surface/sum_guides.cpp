#include "surface/sum_guides.h"

namespace pencil {

void sum_guides(Kernels& kernels, const Buffer<float>& radiance, int capacity, const Buffer<float>& factors, int rays, int first, int count,
                Buffer<float4>& irradiance) {
    kernels.get("sum_guides")
        .args(radiance, capacity, factors, rays, first, count, irradiance)
        .run(static_cast<std::size_t>(count), "sum guides", pencil_group);
}

}  // namespace pencil
