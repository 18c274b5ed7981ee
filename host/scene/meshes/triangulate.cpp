// Ears: corners whose triangle holds no other corner. Cutting them one by one takes the square of the number of corners, so that a file may
// not ask for it with polygons of any size.
#include "scene/meshes/triangulate.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace pencil {
namespace {

constexpr std::size_t most_corners = 2048;

/// Twice the area vector (Newell): of any polygon, flat or not.
glm::dvec3 area_vector(const std::vector<glm::dvec3>& corners) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 2; i < corners.size(); ++i) sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
    return sum;
}

/// Twice the signed area of a triangle.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

bool holds(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& p) {
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// Seen against the area vector along one axis, so that the polygon runs counter-clockwise.
std::vector<glm::dvec2> flattened(const std::vector<glm::dvec3>& corners, const glm::dvec3& area) {
    int drop = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(area[k]) > std::abs(area[drop])) drop = k;
    const int x = (drop + 1) % 3, y = (drop + 2) % 3;
    std::vector<glm::dvec2> flat;
    flat.reserve(corners.size());
    for (const glm::dvec3& p : corners) flat.push_back(area[drop] > 0 ? glm::dvec2(p[x], p[y]) : glm::dvec2(p[y], p[x]));
    return flat;
}

class EarCutter {
public:
    explicit EarCutter(std::vector<glm::dvec2> points) : points_(std::move(points)) {}

    bool is_convex() const {
        const std::size_t n = points_.size();
        for (std::size_t i = 0; i < n; ++i)
            if (turn(points_[i], points_[(i + 1) % n], points_[(i + 2) % n]) < 0) return false;
        return true;
    }

    /// Triangles by the number of their corners in the polygon; the rest of one without ears is a fan.
    std::vector<glm::uvec3> cut() {
        for (std::uint32_t i = 0; i < points_.size(); ++i) left_.push_back(i);
        std::vector<glm::uvec3> result;
        std::size_t at = 0, tried = 0;
        while (left_.size() > 3 && tried < left_.size()) {
            at %= left_.size();
            if (is_ear(at)) {
                result.emplace_back(before(at), left_[at], after(at));
                left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
                tried = 0;
            } else {
                ++at;
                ++tried;
            }
        }
        for (std::size_t i = 2; i < left_.size(); ++i) result.emplace_back(left_[0], left_[i - 1], left_[i]);
        return result;
    }

private:
    std::uint32_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
    std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

    bool is_ear(std::size_t i) const {
        const glm::dvec2 &a = points_[before(i)], &b = points_[left_[i]], &c = points_[after(i)];
        if (turn(a, b, c) <= 0) return false;
        for (const std::uint32_t other : left_) {
            const glm::dvec2& p = points_[other];
            if (p != a && p != b && p != c && holds(a, b, c, p)) return false;
        }
        return true;
    }

    std::vector<glm::dvec2> points_;
    std::vector<std::uint32_t> left_;
};

}  // namespace

void triangulate(const std::vector<std::uint32_t>& polygon, const std::vector<glm::dvec3>& positions, std::vector<glm::uvec3>& triangles) {
    if (polygon.size() > 3 && polygon.size() <= most_corners) {
        std::vector<glm::dvec3> corners;
        for (const std::uint32_t index : polygon) corners.push_back(positions[index]);
        EarCutter cutter(flattened(corners, area_vector(corners)));
        if (!cutter.is_convex()) {
            for (const glm::uvec3& t : cutter.cut()) triangles.emplace_back(polygon[t.x], polygon[t.y], polygon[t.z]);
            return;
        }
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) triangles.emplace_back(polygon[0], polygon[i - 1], polygon[i]);
}

}  // namespace pencil
