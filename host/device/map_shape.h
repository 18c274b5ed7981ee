// Kinds and sizes of the maps of pencils, on the host: how many texels a map has and where they look.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "shared/atlas.h"
#include "shared/map_kind.h"

namespace pencil {

/// A map of PENCIL_MAP_PANELS(kind) squares of n x n texels.
struct MapShape {
    MapShape() = default;
    /// Octahedral.
    MapShape(int map_width) : width(map_width), n(map_width) {}  // NOLINT(google-explicit-constructor): a width is a shape
    /// As many texels as an octahedral map of `map_width`^2, as nearly as squares allow whose width is a multiple of 4. 0: none.
    MapShape(int map_kind, int map_width);

    int panels() const { return PENCIL_MAP_PANELS(kind); }
    /// Texels of a map, without gutters and with.
    int texels() const { return panels() * n * n; }
    int stored() const { return panels() * PENCIL_TILE_TEXELS(n); }

    int kind = PENCIL_MAP_OCTAHEDRAL;
    int width = 0;  // of the octahedral map of as many texels
    int n = 0;      // width of a panel [texels]
};

/// Where a texel looks.
struct TexelView {
    glm::dvec3 direction{0};  // as long as map_texel_direction of kernels/lib/map.cl
    double solid_angle = 0;   // [sr], but for a factor that all texels of a map share
};

/// Texel (column, row) of a map, rows counted over all panels.
TexelView texel_view(const MapShape& shape, int column, int row);

/// "octahedral maps of 64x64 texels", "cube maps of 6 x 28x28 texels".
std::string describe(const MapShape& shape);

}  // namespace pencil
