#include "device/map_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace pencil {

namespace {

/// Widths of panels: packets of 16 texels lie in one map, rays go by blocks of 4 x 4.
constexpr int panel_step = 4;

int panel_width(int kind, int width) {
    const double side = width / std::sqrt(static_cast<double>(PENCIL_MAP_PANELS(kind)));
    return panel_step * std::max(static_cast<int>(std::lround(side / panel_step)), 1);
}

/// kernels/lib/octahedral.cl, oct_to_direction.
glm::dvec3 octahedral_direction(double u, double v) {
    const double z = 1.0 - std::abs(u) - std::abs(v), fold = std::max(-z, 0.0);
    return {u - std::copysign(fold, u), v - std::copysign(fold, v), z};
}

/// cube_to_direction of kernels/lib/cube.cl.
glm::dvec3 cube_direction(double u, double v, int panel) {
    glm::dvec3 out;
    const int axis = panel / 2;
    out[axis] = panel % 2 == 0 ? 1.0 : -1.0;
    out[(axis + 1) % 3] = u;
    out[(axis + 2) % 3] = v;
    return out;
}

/// A direction of a dual map.
glm::dvec3 dual_direction(double u, double v, double z, int panel) { return {u, v, panel == 0 ? z : -z}; }

}  // namespace

MapShape::MapShape(int map_kind, int map_width)
    : kind(map_kind), width(map_width), n(map_kind == PENCIL_MAP_OCTAHEDRAL || map_width == 0 ? map_width : panel_width(kind, width)) {}

TexelView texel_view(const MapShape& shape, int column, int row) {
    const int n = shape.n, panel = row / n;
    const double u = (2.0 * column + 1.0) / n - 1.0, v = (2.0 * (row % n) + 1.0) / n - 1.0;
    const auto linear = [](const glm::dvec3& direction) { return TexelView{direction, std::pow(glm::length(direction), -3.0)}; };
    switch (shape.kind) {
        case PENCIL_MAP_PYRAMID:
            return linear(dual_direction(u, v, 1.0 - std::max(std::abs(u), std::abs(v)), panel));
        case PENCIL_MAP_CUBE:
            return linear(cube_direction(u, v, panel));
        case PENCIL_MAP_PARABOLOID: {
            const double r2 = u * u + v * v, length = 0.5 * (1.0 + r2);
            return {dual_direction(u, v, 0.5 * (1.0 - r2), panel), r2 <= 1.0 ? 1.0 / (length * length) : 0.0};
        }
        default:
            return linear(octahedral_direction(u, v));
    }
}

std::string describe(const MapShape& shape) {
    switch (shape.kind) {
        case PENCIL_MAP_PYRAMID:
            return fmt::format("dual pyramid maps of 2 x {0}x{0} texels", shape.n);
        case PENCIL_MAP_CUBE:
            return fmt::format("cube maps of 6 x {0}x{0} texels", shape.n);
        case PENCIL_MAP_PARABOLOID:
            return fmt::format("dual paraboloid maps of 2 x {0}x{0} texels", shape.n);
        default:
            return fmt::format("octahedral maps of {0}x{0} texels", shape.n);
    }
}

}  // namespace pencil
