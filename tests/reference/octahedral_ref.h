// Octahedral map of thesis 4.3.1 in scalar double precision: direction <-> (u, v) <-> texel, exact solid angles, folding of the gutter.
// (u, v) lies in [-1, 1]^2; texel (x, y) of an n x n tile has its centre at ((2x + 1)/n - 1, (2y + 1)/n - 1).
// Written from the equations alone; used by the tests of kernels/lib/octahedral.cl and of everything that reads a tile.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <stdexcept>
#include <vector>

namespace pencil::ref {

using dvec2 = glm::dvec2;
using dvec3 = glm::dvec3;

constexpr double pi = 3.14159265358979323846;

inline double l1_norm(const dvec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// thesis eq. (4.25). DEVIATION: S is copysign(1, .), never 0: listing 4.2's SGN(0) = 0 maps every v with v_x = 0, v_z < 0 to u = 0.
inline dvec2 direction_to_oct(const dvec3& v) {
    const double w = l1_norm(v);
    const double back = std::max(-v.z, 0.0);
    return {(v.x + std::copysign(back, v.x)) / w, (v.y + std::copysign(back, v.y)) / w};
}

/// Inverse of direction_to_oct; the result has unit L1 norm. From eq. (4.17), whose flip is its own inverse.
inline dvec3 oct_to_direction(const dvec2& uv) {
    const double z = 1.0 - std::abs(uv.x) - std::abs(uv.y);
    if (z >= 0.0) return {uv.x, uv.y, z};
    return {std::copysign(1.0 - std::abs(uv.y), uv.x), std::copysign(1.0 - std::abs(uv.x), uv.y), z};
}

inline dvec2 texel_centre(int x, int y, int n) { return {(2.0 * x + 1.0) / n - 1.0, (2.0 * y + 1.0) / n - 1.0}; }
inline dvec3 texel_direction(int x, int y, int n) { return oct_to_direction(texel_centre(x, y, n)); }

struct Texel {
    int x, y;
};

/// Texel that holds a direction (borders go to the larger index, except at the end of the map).
inline Texel direction_to_texel(const dvec3& v, int n) {
    const dvec2 uv = direction_to_oct(v);
    const auto index = [n](double u) { return std::clamp(static_cast<int>(std::floor((u + 1.0) * 0.5 * n)), 0, n - 1); };
    return {index(uv.x), index(uv.y)};
}

/// Texel that a gutter texel (-1 or n in x, y or both) repeats. The border of the square is glued to itself by half a turn about each
/// edge's middle (thesis figure 4.11), so (-1, y) is (0, n-1-y); a corner gutter takes the diagonally opposite corner.
inline Texel fold(int x, int y, int n) {
    const bool outside_x = x < 0 || x >= n;
    const bool outside_y = y < 0 || y >= n;
    if (outside_x && outside_y) return {x < 0 ? n - 1 : 0, y < 0 ? n - 1 : 0};
    if (outside_x) return {x < 0 ? 0 : n - 1, n - 1 - y};
    if (outside_y) return {n - 1 - x, y < 0 ? 0 : n - 1};
    return {x, y};
}

/// Texel of the opposite direction; n must be even for its centre to be a centre again.
inline Texel antipodal_texel(int x, int y, int n) {
    if (n % 2 != 0) throw std::invalid_argument("antipodal_texel: odd tile size");
    return direction_to_texel(-texel_direction(x, y, n), n);
}

/// Solid angle of the spherical triangle over three directions (van Oosterom & Strackee 1983), positive.
inline double spherical_triangle_area(const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 p = glm::normalize(a), q = glm::normalize(b), r = glm::normalize(c);
    const double numerator = std::abs(glm::dot(p, glm::cross(q, r)));
    return 2.0 * std::atan2(numerator, 1.0 + glm::dot(p, q) + glm::dot(q, r) + glm::dot(r, p));
}

/// Part of a convex polygon where dot(normal, p) >= offset (Sutherland & Hodgman).
inline std::vector<dvec2> clip_half_plane(const std::vector<dvec2>& polygon, const dvec2& normal, double offset) {
    std::vector<dvec2> out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double da = glm::dot(normal, a) - offset, db = glm::dot(normal, b) - offset;
        if (da >= 0.0) out.push_back(a);
        if ((da > 0.0 && db < 0.0) || (da < 0.0 && db > 0.0)) out.push_back(a + (b - a) * (da / (da - db)));
    }
    return out;
}

/// Exact solid angle [sr] of a texel. Within an octant the map is central projection of a plane (thesis table 4.2), so straight lines are
/// arcs of great circles: the texel is cut along the octant borders and the pieces are spherical polygons.
inline double texel_solid_angle(int x, int y, int n) {
    const double step = 2.0 / n, u = -1.0 + x * step, v = -1.0 + y * step;
    const std::vector<dvec2> square{{u, v}, {u + step, v}, {u + step, v + step}, {u, v + step}};
    double area = 0.0;
    for (int octant = 0; octant < 8; ++octant) {
        const double sx = (octant & 1) != 0 ? -1.0 : 1.0, sy = (octant & 2) != 0 ? -1.0 : 1.0, front = (octant & 4) != 0 ? -1.0 : 1.0;
        std::vector<dvec2> piece = clip_half_plane(square, {sx, 0.0}, 0.0);
        piece = clip_half_plane(piece, {0.0, sy}, 0.0);
        piece = clip_half_plane(piece, {-front * sx, -front * sy}, -front);  // front: |u| + |v| <= 1
        for (std::size_t i = 2; i < piece.size(); ++i) {
            const auto lift = [&](const dvec2& p) {  // the octant is known: no sign has to be guessed on its border
                const dvec2 q{std::abs(p.x), std::abs(p.y)};
                return front > 0.0 ? dvec3(sx * q.x, sy * q.y, 1.0 - q.x - q.y)
                                   : dvec3(sx * (1.0 - q.y), sy * (1.0 - q.x), 1.0 - q.x - q.y);
            };
            area += spherical_triangle_area(lift(piece[0]), lift(piece[i - 1]), lift(piece[i]));
        }
    }
    return area;
}

/// Steradians per unit of (u, v) area at a direction: 1 / r^3 with r the L2 norm of the direction of unit L1 norm.
inline double solid_angle_density(const dvec3& v) {
    const double r = glm::length(v) / l1_norm(v);
    return 1.0 / (r * r * r);
}

/// Position of the four texels of a bilinear look-up and their weights; the texels may be gutter texels.
struct Footprint {
    int x, y;       // lower corner: texels x, x + 1 by y, y + 1
    double fx, fy;  // weight of x + 1 and of y + 1
};
inline Footprint bilinear_footprint(const dvec2& uv, int n) {
    const double px = (uv.x + 1.0) * 0.5 * n - 0.5, py = (uv.y + 1.0) * 0.5 * n - 0.5;
    const double x = std::floor(px), y = std::floor(py);
    return {static_cast<int>(x), static_cast<int>(y), px - x, py - y};
}

/// Bilinear look-up of texel(x, y) with 0 <= x, y < n; the gutter is folded.
template <typename TexelFunction>
auto bilinear(const TexelFunction& texel, const dvec2& uv, int n) {
    const Footprint f = bilinear_footprint(uv, n);
    const auto at = [&](int dx, int dy) {
        const Texel t = fold(f.x + dx, f.y + dy, n);
        return texel(t.x, t.y);
    };
    return (at(0, 0) * (1.0 - f.fx) + at(1, 0) * f.fx) * (1.0 - f.fy) + (at(0, 1) * (1.0 - f.fx) + at(1, 1) * f.fx) * f.fy;
}

}  // namespace pencil::ref
