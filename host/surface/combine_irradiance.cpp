#include "surface/combine_irradiance.h"

namespace pencil {

void combine_irradiance(Kernels& kernels, const Buffer<float4>& vectors, const std::vector<glm::dvec3>& factors, int count,
                        Buffer<float4>& target) {
    std::vector<float4> rounded;
    rounded.reserve(factors.size());
    for (const glm::dvec3& f : factors) rounded.emplace_back(glm::vec3(f), 0.0F);
    kernels.get("combine_irradiance")
        .args(vectors, Buffer<float4>(kernels.device(), rounded, "factors"), static_cast<int>(factors.size()), count, target)
        .run(static_cast<std::size_t>(count), "combine irradiance");
}

}  // namespace pencil
