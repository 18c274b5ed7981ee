// Surface pencils in double precision: their frame, and where their irradiance may stand for that of a near point (Ward, Rubinstein and
// Clear 1988; docs/overview.md, "The surface method").
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "reference/direct_ref.h"
#include "shared/surface_pencil.h"

namespace pencil::ref {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Tangents of n: the turn by the least angle that takes the z axis, or -z if that is nearer, to n takes x to t, and y to b or -b
/// (Duff et al. 2017 write it without angles).
struct TangentFrame {
    explicit TangentFrame(const dvec3& n) {
        const double side = n.z < 0.0 ? -1.0 : 1.0, cosine = side * n.z;
        const dvec3 axis = glm::cross(dvec3(0, 0, side), n);  // its length is the sine
        const auto turned = [&](const dvec3& v) {             // Rodrigues' formula
            return cosine * v + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + cosine));
        };
        t = turned({1, 0, 0});
        b = side * turned({0, 1, 0});
    }
    dvec3 t, b;
};

/// Number of the eighth of azimuth of (x, y): bit 2: x < 0, bit 1: y < 0, bit 0: nearer to the y axis. Eighths counted from the x axis.
inline int ring_sector(double x, double y) {
    constexpr int sector[8] = {0, 1, 5, 4, 6, 7, 3, 2};
    const double turn = std::atan2(y, x) / (2 * pi);
    return sector[std::min(static_cast<int>((turn < 0 ? turn + 1 : turn) * 8), 7)];
}

/// How far the point at `step` lies behind the planes at the horizon of its sector: below 1 before them, above 1 behind one. `margin` is
/// lowered to the distance from a decision that rounding may turn.
inline double horizon_depth(const SurfacePencil& p, const dvec3& step, double& margin) {
    const TangentFrame frame(xyz(p.normal));
    const double x = glm::dot(step, frame.t), y = glm::dot(step, frame.b), size = std::abs(x) + std::abs(y);
    if (size > 0.0) margin = std::min({margin, std::abs(x) / size, std::abs(y) / size, std::abs(std::abs(x) - std::abs(y)) / size});
    const int sector = ring_sector(x, y);
    double depth = -infinite;
    for (const int slot : {sector, sector + RING_SECTORS})
        depth = std::max(depth, x * static_cast<double>(p.horizon_x[slot]) + y * static_cast<double>(p.horizon_y[slot]));
    margin = std::min(margin, std::abs(depth - 1.0));
    return depth;
}

constexpr double least_cosine = 0.5;  // of normals that stand for each other
constexpr double most_slope = 0.4;    // of the step against the mean of both tangent planes
/// Shorter steps are none at x: rounding of positions [scene units].
inline double no_step(const dvec3& x) { return 1e-6 * std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)}); }
constexpr double turn_weight = 0.5;  // of the turn of the normal in Ward's error

struct Reuse {
    double distance = infinite;  // infinite: the irradiance may not be used
    double error = infinite;     // Ward's estimate of its relative change: d / R + c sqrt(1 - cos)
    double margin = 1.0;         // relative distance from the nearest decision
};

inline double reuse_error(const SurfacePencil& p, double distance, const dvec3& n) {
    const double turn = std::max(1.0 - glm::dot(xyz(p.normal), n), 0.0);
    return distance / static_cast<double>(p.facing.w) + turn_weight * std::sqrt(turn);
}

/// Whether, and how well, the pencil stands for the point x with normal n.
inline Reuse reuse(const SurfacePencil& p, const dvec3& x, const dvec3& n) {
    const dvec3 step = x - xyz(p.position), normal = xyz(p.normal);
    const double distance = glm::length(step), cosine = glm::dot(normal, n);
    Reuse out;
    out.margin = std::abs(cosine - least_cosine);
    if (cosine < least_cosine) return out;
    if (distance >= no_step(x)) {
        const double slope = std::abs(glm::dot(step, normal + n)) / (2.0 * distance);
        out.margin = std::min(out.margin, std::abs(slope - most_slope));
        if (slope > most_slope) return out;
        if (horizon_depth(p, step, out.margin) >= 1.0) return out;
    }
    out.distance = distance < no_step(x) ? 0.0 : distance;
    out.error = reuse_error(p, out.distance, n);
    return out;
}

}  // namespace pencil::ref
