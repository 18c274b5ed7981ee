// Thins points on surfaces to minimum spacings: Poisson-disc sampling by dart throwing, with a hash of cells.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <unordered_map>
#include <vector>

namespace pencil {

class PointThinner {
public:
    /// Kept points exclude points near them whose normals have at least the cosine `alike`; `most`: the largest spacing.
    PointThinner(float most, float alike) : most_(most), alike_(alike) {}

    /// Keeps the point unless one that was kept within `spacing` excludes it; true if it is kept.
    bool add(const glm::vec3& position, const glm::vec3& normal, float spacing) {
        const glm::ivec3 cell(glm::floor(position / most_));
        if (excluded(key(cell), position, normal, spacing)) return false;  // most are, and cheaply
        const glm::ivec3 low(glm::floor((position - spacing) / most_)), high(glm::floor((position + spacing) / most_));
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y)
                for (int x = low.x; x <= high.x; ++x)
                    if (glm::ivec3(x, y, z) != cell && excluded(key({x, y, z}), position, normal, spacing)) return false;
        const auto [head, added] = heads_.try_emplace(key(cell), -1);
        points_.push_back({position, normal, head->second});
        head->second = static_cast<int>(points_.size()) - 1;
        return true;
    }

private:
    struct Point {
        glm::vec3 position, normal;
        int next;  // in the same cell, -1: none
    };

    /// 21 bits per coordinate.
    static std::uint64_t key(const glm::ivec3& cell) {
        const auto bits = [](int c) { return static_cast<std::uint64_t>(c) & 0x1fffffU; };
        return bits(cell.x) << 42 | bits(cell.y) << 21 | bits(cell.z);
    }

    bool excluded(std::uint64_t cell, const glm::vec3& position, const glm::vec3& normal, float spacing) const {
        const auto head = heads_.find(cell);
        if (head == heads_.end()) return false;
        for (int i = head->second; i >= 0; i = points_[static_cast<std::size_t>(i)].next) {
            const Point& p = points_[static_cast<std::size_t>(i)];
            const glm::vec3 step = p.position - position;
            if (glm::dot(step, step) < spacing * spacing && glm::dot(p.normal, normal) > alike_) return true;
        }
        return false;
    }

    float most_, alike_;
    std::unordered_map<std::uint64_t, int> heads_;
    std::vector<Point> points_;
};

}  // namespace pencil
