#include "surface/transport_irradiance.h"

namespace pencil {

void transport_irradiance(Kernels& kernels, const Surfels& surfels, const SurfaceLinks& links, int count, int n,
                          const Buffer<float4>& source, Buffer<float4>& target, Buffer<float4>& total) {
    kernels.get("transport_irradiance")
        .args(surfels.store(), links.list(), count, n, source, target, total)
        .run(static_cast<std::size_t>(count), "transport irradiance", pencil_group);
}

}  // namespace pencil
