// A field of pencils: centres in the world, and the light that surfaces send to them. Made by one method, shown by another.
#pragma once

#include <cmath>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

namespace pencil {

constexpr int endless_orders = -1;  // PencilField::orders: no limit

/// The maps are octahedral, thesis eq. (4.25), about the world's axes: a texel shows the light that comes from where it looks to. They stand in one
/// image, tile after tile in rows.
struct PencilField {
    int map = 0;                      // width of a map [texels], a multiple of 8
    int orders = endless_orders;      // reflections that the light has made, at most
    double free_share = 1;            // of the scene's box, where centres may lie: they are uniform there
    std::vector<glm::dvec3> centres;  // [world units]
    std::vector<float> light;         // reflected radiance, rgb of each texel of the image; emission is not among it [W m^-2 sr^-1]

    int count() const { return static_cast<int>(centres.size()); }
    /// Tiles of a row of the image.
    int columns() const { return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count())))); }
    int rows() const { return columns() > 0 ? (count() + columns() - 1) / columns() : 0; }
    int width() const { return map * columns(); }
    int height() const { return map * rows(); }
    /// Of the first value of texel (x, y) of a tile.
    std::size_t index(int tile, int x, int y) const {
        const auto row = static_cast<std::size_t>(tile / columns() * map + y),
                   column = static_cast<std::size_t>(tile % columns() * map + x);
        return 3 * (row * static_cast<std::size_t>(width()) + column);
    }
    /// The tile of a pixel of the image, or count(): none.
    int tile_of(int x, int y) const {
        const int tile = y / map * columns() + x / map;
        return tile < count() ? tile : count();
    }
};

/// Where the light of single pencils of a field comes from.
class FieldSource {
public:
    virtual ~FieldSource() = default;
    /// rgb of the map x map texels of a pencil, row by row, as in PencilField::light. SceneError.
    virtual std::vector<float> light(int pencil) = 0;
};

}  // namespace pencil
