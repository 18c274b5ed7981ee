// Thins points on surfaces to minimum spacings: Poisson-disc sampling by dart throwing, with a hash of cells.
#pragma once

#include <cstdint>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace pencil {

class PointThinner {
public:
    /// Kept points exclude points near them whose normals have at least the cosine `alike`; `most`: the largest spacing.
    PointThinner(float most, float alike) : most_(most), alike_(alike), heads_(1024, -1) {}

    float most() const { return most_; }

    /// Keeps the point unless one that was kept within `spacing` excludes it; true if it is kept.
    bool add(const glm::vec3& position, const glm::vec3& normal, float spacing) {
        const glm::ivec3 cell = cell_of(position);
        if (excluded(cell, position, normal, spacing)) return false;  // most are, and cheaply
        const glm::ivec3 low = cell_of(position - spacing), high = cell_of(position + spacing);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    if (glm::ivec3(x, y, z) != cell && excluded({x, y, z}, position, normal, spacing)) return false;
        points_.push_back({position, normal, -1});
        if (points_.size() <= heads_.size())
            link(points_.size() - 1);
        else
            grow();
        return true;
    }

private:
    struct Point {
        glm::vec3 position, normal;
        int next;  // in the same slot, -1: none
    };

    glm::ivec3 cell_of(const glm::vec3& position) const { return glm::ivec3(glm::floor(position / most_)); }

    /// Slot of a cell; cells that share one only cost time.
    std::size_t slot(const glm::ivec3& cell) const {
        const std::uint32_t hash = static_cast<std::uint32_t>(cell.x) * 0x9e3779b1U ^ static_cast<std::uint32_t>(cell.y) * 0x85ebca77U ^
                                   static_cast<std::uint32_t>(cell.z) * 0xc2b2ae3dU;
        return (hash ^ hash >> 15) & (heads_.size() - 1);
    }

    void link(std::size_t point) {
        int& head = heads_[slot(cell_of(points_[point].position))];
        points_[point].next = head;
        head = static_cast<int>(point);
    }

    void grow() {
        heads_.assign(4 * heads_.size(), -1);
        for (std::size_t i = 0; i < points_.size(); ++i) link(i);
    }

    bool excluded(const glm::ivec3& cell, const glm::vec3& position, const glm::vec3& normal, float spacing) const {
        for (int i = heads_[slot(cell)]; i >= 0; i = points_[static_cast<std::size_t>(i)].next) {
            const Point& p = points_[static_cast<std::size_t>(i)];
            const glm::vec3 step = p.position - position;
            if (glm::dot(step, step) < spacing * spacing && glm::dot(p.normal, normal) > alike_) return true;
        }
        return false;
    }

    float most_, alike_;
    std::vector<int> heads_;  // a power of two of slots
    std::vector<Point> points_;
};

}  // namespace pencil
