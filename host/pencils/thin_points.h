// Thins points on surfaces to a minimum spacing: Poisson-disc sampling by dart throwing, with a hash of cells.
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
    /// Points nearer than `spacing` whose normals have at least the cosine `alike` exclude each other.
    PointThinner(float spacing, float alike) : spacing_(spacing), alike_(alike) {}

    /// Keeps the point unless one that was kept excludes it; true if it is kept.
    bool add(const glm::vec3& position, const glm::vec3& normal) {
        const glm::ivec3 cell(glm::floor(position / spacing_));
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    if (excluded(key(cell + glm::ivec3(dx, dy, dz)), position, normal)) return false;
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

    bool excluded(std::uint64_t cell, const glm::vec3& position, const glm::vec3& normal) const {
        const auto head = heads_.find(cell);
        if (head == heads_.end()) return false;
        for (int i = head->second; i >= 0; i = points_[static_cast<std::size_t>(i)].next) {
            const Point& p = points_[static_cast<std::size_t>(i)];
            const glm::vec3 step = p.position - position;
            if (glm::dot(step, step) < spacing_ * spacing_ && glm::dot(p.normal, normal) > alike_) return true;
        }
        return false;
    }

    float spacing_, alike_;
    std::unordered_map<std::uint64_t, int> heads_;
    std::vector<Point> points_;
};

}  // namespace pencil
