// The pencils of a set sorted into the cells of a grid, for look-ups near a point (kernels/lib/pencil_grid.cl).
#pragma once

#include <tuple>

#include "cl/buffer.h"
#include "pencils/flat_scene.h"
#include "shared/surface_pencil.h"

namespace pencil {

struct DeviceGrid {
    DeviceGrid() = default;
    /// A grid over the scene; a pencil is in every cell that its radius (normal.w) reaches.
    DeviceGrid(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils, const FlatScene& flat);

    /// Arguments `grid, starts, entries` of kernels.
    auto list() const { return std::tie(grid, starts, entries); }

    PencilGrid grid{};
    Buffer<int> starts;     // [cells + 1]: first block of each cell
    Buffer<float> entries;  // blocks of ENTRY_FIELDS x packet width
};

}  // namespace pencil
