#include "surface/dot_irradiance.h"

namespace pencil {

namespace {

/// Parts of a product: enough to keep a device busy, few enough to read.
constexpr int parts = 64;

}  // namespace

std::vector<glm::dvec3> dot_irradiance(Kernels& kernels, const Buffer<float4>& basis, int vectors, const Buffer<float4>& other, int count) {
    const auto items = static_cast<std::size_t>(vectors) * static_cast<std::size_t>(parts);
    Buffer<float4> sums(kernels.device(), items, "inner products");
    kernels.get("dot_irradiance").args(basis, vectors, other, count, parts, sums).run(items, "dot irradiance");
    std::vector<glm::dvec3> products(static_cast<std::size_t>(vectors), glm::dvec3(0));
    const std::vector<float4> found = sums.read();
    for (std::size_t i = 0; i < items; ++i) products[i / parts] += glm::dvec3(found[i]);
    return products;
}

}  // namespace pencil
