// Thins points on surfaces to minimum spacings: Poisson-disc sampling by dart throwing, with a hash of cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace pencil {

/// Spacings may differ by any factor: kept points lie in cells of many widths at once, each half as wide as the next, and a spacing is looked
/// up where cells are just as wide.
class PointThinner {
public:
    /// Kept points exclude points near them whose normals have at least the cosine `alike`; `most`: the largest spacing.
    PointThinner(float most, float alike) : most_(most), alike_(alike), heads_(1024 * levels, -1) {}

    float most() const { return most_; }

    /// Keeps the point unless one that was kept within `spacing` excludes it; true if it is kept.
    bool add(const glm::vec3& position, const glm::vec3& normal, float spacing) {
        const int level = std::clamp(static_cast<int>(std::log2(most_ / spacing)), 0, levels - 1);
        const glm::ivec3 cell = cell_of(position, level);
        if (excluded(cell, level, position, normal, spacing)) return false;  // most are, and cheaply
        const glm::ivec3 low = cell_of(position - spacing, level), high = cell_of(position + spacing, level);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    if (glm::ivec3(x, y, z) != cell && excluded({x, y, z}, level, position, normal, spacing)) return false;
        keep(position, normal);
        return true;
    }

private:
    static constexpr int levels = 20;  // of cells, the widest as wide as the largest spacing

    struct Point {
        glm::vec3 position, normal;
        int next[levels];  // in the same slot, -1: none
    };

    glm::ivec3 cell_of(const glm::vec3& position, int level) const {
        return glm::ivec3(glm::floor(position * (std::ldexp(1.0F, level) / most_)));
    }

    /// Slot of a cell; cells that share one only cost time.
    std::size_t slot(const glm::ivec3& cell, int level) const {
        const std::uint32_t hash = static_cast<std::uint32_t>(cell.x) * 0x9e3779b1U ^ static_cast<std::uint32_t>(cell.y) * 0x85ebca77U ^
                                   static_cast<std::uint32_t>(cell.z) * 0xc2b2ae3dU;
        return ((hash ^ hash >> 15) & (heads_.size() / levels - 1)) * levels + static_cast<std::size_t>(level);
    }

    void keep(const glm::vec3& position, const glm::vec3& normal) {
        points_.push_back({position, normal, {}});
        if (points_.size() * levels <= heads_.size()) return link(points_.size() - 1);
        heads_.assign(4 * heads_.size(), -1);
        for (std::size_t i = 0; i < points_.size(); ++i) link(i);
    }

    void link(std::size_t point) {
        for (int level = 0; level < levels; ++level) {
            int& head = heads_[slot(cell_of(points_[point].position, level), level)];
            points_[point].next[level] = head;
            head = static_cast<int>(point);
        }
    }

    bool excluded(const glm::ivec3& cell, int level, const glm::vec3& position, const glm::vec3& normal, float spacing) const {
        for (int i = heads_[slot(cell, level)]; i >= 0; i = points_[static_cast<std::size_t>(i)].next[level]) {
            const Point& p = points_[static_cast<std::size_t>(i)];
            const glm::vec3 step = p.position - position;
            if (glm::dot(step, step) < spacing * spacing && glm::dot(p.normal, normal) > alike_) return true;
        }
        return false;
    }

    float most_, alike_;
    std::vector<int> heads_;  // a power of two of slots for each level
    std::vector<Point> points_;
};

}  // namespace pencil
