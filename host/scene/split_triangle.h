// Splits triangles that are large beside their distance from the eye. A float knows a hit to some rounding errors of the largest coordinate of
// its triangle: on a ground of a thousand kilometres that is a metre, on pieces like these it is less than a
// ten-thousandth of the distance from the eye.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <tuple>
#include <vector>

namespace pencil {

/// Corners of a piece: where they are, and their barycentric weights in the whole triangle.
struct TrianglePiece {
    std::array<glm::dvec3, 3> corner, weight;
};

class TriangleSplitter {
public:
    /// Edges of pieces are at most so many times as long as they are far from the eye.
    static constexpr double most_length = 1024;

    /// Nothing nearer to the eye than `nearest` is seen.
    TriangleSplitter(const glm::dvec3& eye, double nearest) : eye_(eye), nearest_(nearest) {}

    /// The pieces; one, the whole triangle, almost always. Triangles that share an edge are split at the same points of it.
    std::vector<TrianglePiece> split(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
        std::vector<TrianglePiece> open{{{a, b, c}, {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)}}}, done;
        const double least = least_length * longest(open[0]);
        if (const double height = plane_distance(open[0]); height >= 0 && longest(open[0]) > most_length * std::max(height, nearest_))
            split_inside(open);
        while (!open.empty() && done.size() < most_pieces) {
            const TrianglePiece piece = open.back();
            open.pop_back();
            const int k = edge_to_split(piece, least);
            if (k < 0)
                done.push_back(piece);
            else
                bisect(piece, static_cast<std::size_t>(k), open);
        }
        done.insert(done.end(), open.begin(), open.end());
        return done;
    }

private:
    static constexpr std::size_t most_pieces = 4096;  // where the eye lies on a triangle
    static constexpr double least_length = 1e-9;      // of an edge of a piece, in terms of the longest one: smaller pieces gain nothing

    static double length(const TrianglePiece& t, std::size_t k) { return glm::distance(t.corner[k], t.corner[(k + 1) % 3]); }
    static double longest(const TrianglePiece& t) { return std::max({length(t, 0), length(t, 1), length(t, 2)}); }

    /// Distance of the eye from the plane if it stands over the inside of the triangle, -1 otherwise.
    double plane_distance(const TrianglePiece& t) const {
        const glm::dvec3 w = foot(t);
        if (!(std::min({w.x, w.y, w.z}) > 0)) return -1;
        return glm::distance(eye_, w.x * t.corner[0] + w.y * t.corner[1] + w.z * t.corner[2]);
    }

    /// Barycentric weights of the eye's projection.
    glm::dvec3 foot(const TrianglePiece& t) const {
        const glm::dvec3 u = t.corner[1] - t.corner[0], v = t.corner[2] - t.corner[0], p = eye_ - t.corner[0], n = glm::cross(u, v);
        const double square = glm::dot(n, n);
        const double y = glm::dot(glm::cross(p, v), n) / square, z = glm::dot(glm::cross(u, p), n) / square;
        return {1 - y - z, y, z};
    }

    /// A fan about the eye's projection: no edge of the whole triangle changes.
    void split_inside(std::vector<TrianglePiece>& open) const {
        const TrianglePiece whole = open[0];
        const glm::dvec3 w = foot(whole), at = w.x * whole.corner[0] + w.y * whole.corner[1] + w.z * whole.corner[2];
        open.clear();
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            open.push_back({{whole.corner[k], whole.corner[next], at}, {whole.weight[k], whole.weight[next], w}});
        }
    }

    /// The longest edge that is too long for where it lies, -1 if none is.
    int edge_to_split(const TrianglePiece& t, double least) const {
        int found = -1;
        double most = least * least;
        for (std::size_t k = 0; k < 3; ++k) {
            glm::dvec3 a = t.corner[k], b = t.corner[(k + 1) % 3];
            if (std::tie(b.x, b.y, b.z) < std::tie(a.x, a.y, a.z)) std::swap(a, b);  // the same decision from both sides
            const glm::dvec3 step = b - a;
            const double square = glm::dot(step, step);
            if (!(square > most)) continue;
            const double along = glm::clamp(glm::dot(eye_ - a, step) / square, 0.0, 1.0);
            const double distance = std::max(glm::distance(a + along * step, eye_), nearest_);
            if (square > most_length * most_length * distance * distance) {
                most = square;
                found = static_cast<int>(k);
            }
        }
        return found;
    }

    static void bisect(const TrianglePiece& t, std::size_t k, std::vector<TrianglePiece>& open) {
        const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
        const glm::dvec3 at = 0.5 * (t.corner[k] + t.corner[next]), w = 0.5 * (t.weight[k] + t.weight[next]);
        open.push_back({{t.corner[k], at, t.corner[last]}, {t.weight[k], w, t.weight[last]}});
        open.push_back({{at, t.corner[next], t.corner[last]}, {w, t.weight[next], t.weight[last]}});
    }

    glm::dvec3 eye_;
    double nearest_;
};

}  // namespace pencil
