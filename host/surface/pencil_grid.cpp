#include "surface/pencil_grid.h"

#include <algorithm>
#include <cstring>

namespace pencil {

namespace {

/// Cells along the longest axis of the grid at most.
constexpr double most_cells = 64;

glm::ivec3 cell_of(const PencilGrid& grid, const glm::vec3& p) {
    const glm::ivec3 cell((p - glm::vec3(grid.low)) * grid.low.w);
    return glm::clamp(cell, glm::ivec3(0), glm::ivec3(grid.size_x, grid.size_y, grid.size_z) - 1);
}

/// Calls visit(cell index) for the cells that a pencil's radius reaches.
template <typename Visit>
void for_cells(const PencilGrid& grid, const SurfacePencil& pencil, Visit visit) {
    const glm::vec3 radius(pencil.normal.w), at(pencil.position);
    const glm::ivec3 low = cell_of(grid, at - radius), high = cell_of(grid, at + radius);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const int cell = (z * grid.size_y + y) * grid.size_x + x;
                visit(static_cast<std::size_t>(cell));
            }
}

}  // namespace

DeviceGrid::DeviceGrid(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils, const FlatScene& flat) {
    const glm::vec3 extent(flat.high - flat.low);
    float size = std::max({extent.x, extent.y, extent.z}) / static_cast<float>(most_cells);
    for (const SurfacePencil& p : pencils) size = std::max(size, 0.5F * p.normal.w);
    grid.low = float4(glm::vec3(flat.low), 1.0F / size);
    const glm::ivec3 cells = glm::ivec3(extent / size) + 1;
    grid.size_x = cells.x;
    grid.size_y = cells.y;
    grid.size_z = cells.z;
    const auto width = static_cast<std::size_t>(device->packet_width());
    std::vector<int> count(static_cast<std::size_t>(cells.x * cells.y * cells.z), 0), start(count.size() + 1, 0);
    for (const SurfacePencil& p : pencils) for_cells(grid, p, [&](std::size_t cell) { ++count[cell]; });
    for (std::size_t c = 0; c < count.size(); ++c)
        start[c + 1] = start[c] + (count[c] + static_cast<int>(width) - 1) / static_cast<int>(width);
    std::vector<float> entry(std::max<std::size_t>(static_cast<std::size_t>(start.back()), 1) * ENTRY_FIELDS * width, 0.0F);
    for (std::size_t i = pencils.size(); i-- > 0;)
        for_cells(grid, pencils[i], [&](std::size_t cell) {
            const auto at = static_cast<std::size_t>(--count[cell]);
            float* block = entry.data() + (static_cast<std::size_t>(start[cell]) + at / width) * ENTRY_FIELDS * width + at % width;
            const SurfacePencil& p = pencils[i];
            const float values[] = {p.position.x, p.position.y, p.position.z, p.normal.w, p.normal.x, p.normal.y, p.normal.z};
            for (std::size_t f = 0; f < ENTRY_PENCIL; ++f) block[f * width] = values[f];
            const int index = static_cast<int>(i);
            std::memcpy(block + ENTRY_PENCIL * width, &index, sizeof(index));
        });
    starts = Buffer<int>(device, start, "grid of surface pencils");
    entries = Buffer<float>(device, entry, "entries of the grid");
}

}  // namespace pencil
