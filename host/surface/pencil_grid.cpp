#include "surface/pencil_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>

namespace pencil {

namespace {

/// Pencils so small that they need more join level 0.
constexpr int most_levels = 24;
/// A radius reaches at most PENCIL_GRID_REACH = 1 cells: with its own it reaches three along each axis, by rounding one more.
constexpr int most_cells = 4 * 4 * 4;

/// A radius that is as wide as its level allows, up to rounding, does not leave it.
constexpr float rounded = 0.99999F;

/// Width of the cells of a level in terms of those of level 0.
float level_width(int level) { return std::pow(PENCIL_GRID_STEP, static_cast<float>(level)); }

/// Slots of the cells of its level that a pencil's radius reaches, each once.
struct Slots {
    std::array<int, most_cells> slot;
    std::size_t count = 0;

    Slots(const PencilGrid& grid, const SurfacePencil& pencil) {
        const float radius = pencil.normal.w, width = 1.0F / grid.origin.w;
        int level = 0;
        while (level + 1 < grid.levels && PENCIL_GRID_REACH * width * level_width(level) < rounded * radius) ++level;
        const float scale = grid.origin.w / level_width(level);
        const glm::vec3 at = glm::vec3(pencil.position) - glm::vec3(grid.origin);
        const glm::ivec3 low(glm::floor((at - radius) * scale)), high(glm::floor((at + radius) * scale));
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x) {
                    // The point of the cell that is nearest to the pencil.
                    const glm::vec3 cell(x, y, z), nearest = glm::clamp(at * scale, cell, cell + 1.0F) - at * scale;
                    if (count < slot.size() && glm::dot(nearest, nearest) <= radius * radius * scale * scale)
                        slot[count++] = PENCIL_GRID_SLOT(x, y, z, level, grid.slots);
                }
        // Cells may share a slot.
        const auto end = slot.begin() + static_cast<std::ptrdiff_t>(count);
        std::sort(slot.begin(), end);
        count = static_cast<std::size_t>(std::unique(slot.begin(), end) - slot.begin());
    }
};

/// The radius that half of the pencils do not exceed is the widest of its level: most pencils have it or a little less, and a look-up then
/// finds them on one level.
PencilGrid grid_of(const std::vector<SurfacePencil>& pencils) {
    PencilGrid grid{};
    grid.slots = 64;
    grid.count = static_cast<int>(pencils.size());
    if (pencils.empty()) return grid;  // no level, so nothing is found
    while (grid.slots < 16 * grid.count) grid.slots *= 2;
    std::vector<float> radii;
    radii.reserve(pencils.size());
    glm::vec3 low(std::numeric_limits<float>::max());
    for (const SurfacePencil& p : pencils) {
        radii.push_back(p.normal.w);
        low = glm::min(low, glm::vec3(p.position) - p.normal.w);
    }
    const auto middle = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
    std::nth_element(radii.begin(), middle, radii.end());
    const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
    const auto steps = [](float from, float to) {
        return std::clamp(static_cast<int>(std::ceil(std::log(to / from) / std::log(PENCIL_GRID_STEP))), 0, most_levels / 2 - 1);
    };
    const int below = steps(*smallest, *middle);
    grid.levels = below + 1 + steps(*middle, *largest);
    grid.origin = float4(low, PENCIL_GRID_REACH / *middle * level_width(below));
    return grid;
}

}  // namespace

DeviceGrid::DeviceGrid(const std::shared_ptr<Device>& device, const std::vector<SurfacePencil>& pencils) : grid(grid_of(pencils)) {
    const auto width = static_cast<std::size_t>(device->packet_width());
    std::vector<Slots> slots;
    slots.reserve(pencils.size());
    for (const SurfacePencil& p : pencils) slots.emplace_back(grid, p);
    std::vector<int> count(static_cast<std::size_t>(grid.levels) * static_cast<std::size_t>(grid.slots), 0), start(count.size() + 1, 0);
    for (const Slots& s : slots)
        for (std::size_t k = 0; k < s.count; ++k) ++count[static_cast<std::size_t>(s.slot[k])];
    for (std::size_t c = 0; c < count.size(); ++c)
        start[c + 1] = start[c] + (count[c] + static_cast<int>(width) - 1) / static_cast<int>(width);
    std::vector<float> entry(std::max<std::size_t>(static_cast<std::size_t>(start.back()), 1) * ENTRY_FIELDS * width, 0.0F);
    for (std::size_t i = pencils.size(); i-- > 0;)
        for (std::size_t k = 0; k < slots[i].count; ++k) {
            const auto slot = static_cast<std::size_t>(slots[i].slot[k]), at = static_cast<std::size_t>(--count[slot]);
            float* block = entry.data() + (static_cast<std::size_t>(start[slot]) + at / width) * ENTRY_FIELDS * width + at % width;
            const SurfacePencil& p = pencils[i];
            const float values[] = {p.position.x, p.position.y, p.position.z, p.normal.w, p.normal.x, p.normal.y, p.normal.z};
            for (std::size_t f = 0; f < ENTRY_PENCIL; ++f) block[f * width] = values[f];
            const int index = static_cast<int>(i);
            std::memcpy(block + ENTRY_PENCIL * width, &index, sizeof(index));
        }
    starts = Buffer<int>(device, start, "grid of surface pencils");
    entries = Buffer<float>(device, entry, "entries of the grid");
}

}  // namespace pencil
