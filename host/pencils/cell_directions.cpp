#include "pencils/cell_directions.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "shared/weights.h"

namespace pencil {

namespace {

constexpr int tile_width = 4;
static_assert(tile_width * tile_width == PENCIL_CELL_TILE);

/// Point (a, b) of the square [-1, 1]^2 to the hemisphere; texel centres of even grids never lie at its middle.
glm::dvec3 to_hemisphere(double a, double b) {
    const double quarter = std::atan(1.0);
    const bool wide = std::abs(a) > std::abs(b);
    const double radius = wide ? a : b, angle = quarter * (wide ? b / a : a / b);
    const double x = radius * (wide ? std::cos(angle) : std::sin(angle)), y = radius * (wide ? std::sin(angle) : std::cos(angle));
    return {x, y, std::sqrt(1.0 - radius * radius)};
}

}  // namespace

std::vector<float4> cell_directions(int grid) {
    std::vector<float4> axes, directions;
    for (int tile = 0; tile < grid * grid / PENCIL_CELL_TILE; ++tile) {
        const int left = tile % (grid / tile_width) * tile_width, top = tile / (grid / tile_width) * tile_width;
        std::vector<glm::dvec3> texels;
        glm::dvec3 sum(0);
        for (int k = 0; k < PENCIL_CELL_TILE; ++k) {
            const int x = left + k % tile_width, y = top + k / tile_width;
            texels.push_back(to_hemisphere((2.0 * x + 1.0) / grid - 1.0, (2.0 * y + 1.0) / grid - 1.0));
            sum += texels.back();
        }
        const glm::dvec3 axis = glm::normalize(sum);
        double cosine = 1.0;
        for (const glm::dvec3& direction : texels) {
            cosine = std::min(cosine, glm::dot(axis, direction));
            directions.emplace_back(glm::vec3(direction), 0.0F);
        }
        axes.emplace_back(glm::vec3(axis), static_cast<float>(2.0 * cosine * cosine - 1.0));
    }
    axes.insert(axes.end(), directions.begin(), directions.end());
    return axes;
}

}  // namespace pencil
