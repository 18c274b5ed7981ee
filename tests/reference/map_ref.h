// What the references of all map parameterisations offer, and measures that need nothing else: solid angles from directions alone.
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "reference/octahedral_ref.h"

namespace pencil::ref {

/// A point of a map: (u, v) in [-1, 1]^2 of a tile, one of the squares that kernels/lib/panels.cl calls panels.
struct MapPoint {
    int tile;
    dvec2 uv;
};

struct Map {
    std::string name;
    int tiles;
    std::function<MapPoint(const dvec3&)> to_point;
    std::function<dvec3(int tile, const dvec2&)> to_direction;  // of any length
    std::function<bool(const dvec2&)> covers;                   // this part of a tile holds its own directions, the rest repeats others
    std::function<dvec3(int tile, int x, int y, int n)> stored_direction;  // what a texel holds, gutter included (-1 and n)
    bool seamless;  // bilinear look-ups agree on both sides of a seam whatever the texels hold, not just for smooth contents
};

/// How GoogleTest names a map.
inline void PrintTo(const Map& map, std::ostream* out) { *out << map.name; }

/// True if all of a cell is covered: the covered part of a tile is convex.
inline bool covers_cell(const Map& map, const dvec2& low, const dvec2& high) {
    return map.covers(low) && map.covers(high) && map.covers({low.x, high.y}) && map.covers({high.x, low.y});
}

/// Centroid of the covered ones of grid x grid points of a cell, itself covered. False if none is.
inline bool covered_point(const Map& map, const dvec2& low, const dvec2& high, dvec2& point) {
    constexpr int grid = 16;
    point = 0.5 * (low + high);
    if (covers_cell(map, low, high)) return true;
    dvec2 sum(0.0);
    int count = 0;
    for (int i = 0; i < grid * grid; ++i) {
        const int column = i % grid, row = i / grid;
        const dvec2 p = low + (high - low) * dvec2(column + 0.5, row + 0.5) / static_cast<double>(grid);
        if (!map.covers(p)) continue;
        sum += p;
        ++count;
    }
    if (count > 0) point = sum / static_cast<double>(count);
    return count > 0;
}

/// The point farthest from `inside` towards `to` that the map still covers.
inline dvec2 last_covered(const Map& map, const dvec2& inside, const dvec2& to) {
    if (map.covers(to)) return to;
    double low = 0.0, high = 1.0;
    for (int i = 0; i < 50; ++i) {
        const double t = 0.5 * (low + high);
        (map.covers(glm::mix(inside, to, t)) ? low : high) = t;
    }
    return glm::mix(inside, to, low);
}

/// Solid angle [sr] of the part of low .. high in a tile that the map covers, from its border alone: 4 x `segments` points joined by arcs
/// of great circles. Exact where the map is linear between them; otherwise the error falls with the square of the segments.
inline double solid_angle(const Map& map, int tile, const dvec2& low, const dvec2& high, int segments) {
    dvec2 inside;
    if (!covered_point(map, low, high, inside)) return 0.0;
    const dvec2 corners[4] = {low, {high.x, low.y}, high, {low.x, high.y}};
    const auto border = [&](int i) {
        const int side = i / segments, step = i % segments;
        const dvec2 p = glm::mix(corners[side % 4], corners[(side + 1) % 4], step / static_cast<double>(segments));
        return glm::normalize(map.to_direction(tile, last_covered(map, inside, p)));
    };
    const dvec3 o = glm::normalize(map.to_direction(tile, inside));
    double area = 0.0;
    for (int i = 0; i < 4 * segments; ++i) {
        const dvec3 p = border(i), q = border(i + 1);
        area += 2.0 * std::atan2(glm::dot(o, glm::cross(p, q)), 1.0 + glm::dot(o, p) + glm::dot(p, q) + glm::dot(q, o));
    }
    return std::abs(area);
}

/// The same of texel (x, y) of n x n.
inline double texel_solid_angle(const Map& map, int tile, int x, int y, int n, int segments = 32) {
    const dvec2 low(2.0 * x / n - 1.0, 2.0 * y / n - 1.0);
    return solid_angle(map, tile, low, low + 2.0 / n, segments);
}

/// Bilinear look-up of value(stored direction) in a tile of n x n with its gutter.
template <typename Value>
double bilinear(const Map& map, const Value& value, const dvec3& direction, int n) {
    const MapPoint p = map.to_point(direction);
    const Footprint f = bilinear_footprint(p.uv, n);
    const auto at = [&](int dx, int dy) { return value(map.stored_direction(p.tile, f.x + dx, f.y + dy, n)); };
    return (at(0, 0) * (1.0 - f.fx) + at(1, 0) * f.fx) * (1.0 - f.fy) + (at(0, 1) * (1.0 - f.fx) + at(1, 1) * f.fx) * f.fy;
}

inline Map octahedral_map() {
    return {"octahedral",
            1,
            [](const dvec3& v) {
                return MapPoint{0, direction_to_oct(v)};
            },
            [](int, const dvec2& uv) { return oct_to_direction(uv); },
            [](const dvec2&) { return true; },
            [](int, int x, int y, int n) {
                const Texel t = fold(x, y, n);
                return texel_direction(t.x, t.y, n);
            },
            true};
}

/// Hemisphere of a dual map that holds a direction, and its z there.
inline int dual_tile(const dvec3& v) { return v.z < 0.0 ? 1 : 0; }
inline dvec3 mirrored(const dvec3& v, int tile) { return tile == 0 ? v : dvec3(v.x, v.y, -v.z); }

}  // namespace pencil::ref
