// The pencils of a set sorted into the cells of a grid, for look-ups near a point (kernels/lib/pencil_grid.cl).
#pragma once

#include <tuple>

#include "cl/buffer.h"
#include "shared/surface_pencil.h"

namespace pencil {

struct DeviceGrid {
    DeviceGrid() = default;
    /// A pencil is in every cell of its level that its radius (normal.w) reaches.
    DeviceGrid(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils);

    /// Arguments `grid, starts, entries` of kernels.
    auto list() const { return std::tie(grid, starts, entries); }

    PencilGrid grid{};
    Buffer<int> starts;     // [levels * slots + 1]: first block of each slot
    Buffer<float> entries;  // blocks of ENTRY_FIELDS x packet width
};

}  // namespace pencil
