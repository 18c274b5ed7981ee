// Directions over the hemisphere about +z that sample cells of it, Voronoi's or of a power diagram.
#pragma once

#include <vector>

#include "shared/types.h"

namespace pencil {

/// grid x grid directions of equal cosine-weighted solid angle pi / grid^2, the centres of the texels of the concentric map of square to
/// disc (Shirley and Chiu 1997) projected to the hemisphere (Malley). `grid` is a multiple of 4: tiles are 4 x 4 texels. First come the
/// axes of the tiles, w the cosine of twice the greatest angle between the axis and a direction of its tile; then the directions, tile by
/// tile.
std::vector<float4> cell_directions(int grid);

}  // namespace pencil
