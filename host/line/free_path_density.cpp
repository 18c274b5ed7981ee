#include "line/free_path_density.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace pencil {

std::tuple<float4, float4, float> even_density(const CentreSpace& space) {
    constexpr double flattest = 1e-9;  // scenes without volume have finite densities, too
    const double volume = std::max(space.volume, flattest * std::pow(glm::distance(space.low, space.high), 3));
    return {float4(glm::vec3(space.low), 0.0F), float4(glm::vec3(space.high), 0.0F), static_cast<float>(volume)};
}

void free_path_density(Kernels& kernels, int first, int count, const CentreSpace& space, PencilSet& set) {
    kernels.get("free_path_density")
        .args(set.maps->hits, set.maps->tiles(first, count), even_density(space), set.radiance)
        .run(static_cast<std::size_t>(count) * static_cast<std::size_t>(set.maps->texels()), "pencil density");
}

}  // namespace pencil
