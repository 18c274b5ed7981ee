#include "line/sum_radiance.h"

namespace pencil {

std::vector<float4> mean_radiance(Kernels& kernels, const PencilSet& set) {
    Buffer<float4> means(kernels.device(), static_cast<std::size_t>(set.maps->count), "mean radiance");
    kernels.get("sum_radiance")
        .args(set.radiance, set.maps->count, set.maps->n, means)
        .run(static_cast<std::size_t>(set.maps->count), "mean radiance");
    return means.read();
}

glm::dvec3 sum_radiance(Kernels& kernels, const PencilSet& set) {
    glm::dvec3 sum(0);
    for (const float4& mean : mean_radiance(kernels, set)) sum += glm::dvec3(mean);
    return sum / static_cast<double>(set.maps->count);
}

}  // namespace pencil
