// The nearest triangle along a ray by trying all of them in double precision: the oracle of the rasteriser (thesis eq. 5.14's h(x, w)).
// Both faces count; coordinates are those of a normalised scene, at most about 1. Results that float arithmetic may decide otherwise are
// recognised, not tolerated in general: `margin` says how near a result is to such a tie, and `is_plausible` accepts exactly the answers
// that a tie allows.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "reference/tolerances.h"

namespace pencil::ref {

using dvec3 = glm::dvec3;

struct Triangle {
    dvec3 v0, v1, v2;
    int plane = 0;  // coplanar neighbours share it
};

/// How one ray meets one triangle's plane.
struct Crossing {
    double t = 0.0;        // ray parameter, may be negative or infinite
    double inside = -1.0;  // smallest signed volume (ray, edge) / (|d| |a| |b|), a and b the edge's ends seen from the origin; > 0: a hit
    double plane = 0.0;    // distance of the ray's origin from the plane
    double slant = 1.0;    // relative error of t per rounding error of a coordinate of size 1: large if the origin is near the plane
};

inline Crossing cross_triangle(const dvec3& origin, const dvec3& direction, const Triangle& triangle) {
    const dvec3 a = triangle.v0 - origin, b = triangle.v1 - origin, c = triangle.v2 - origin;
    const dvec3 normal = glm::cross(triangle.v1 - triangle.v0, triangle.v2 - triangle.v0);
    const double area = glm::length(normal);
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c), ld = glm::length(direction);
    Crossing out;
    if (!(area > 0.0) || !(std::min({la, lb, lc}) > 0.0)) return out;  // origin on a corner: its plane passes through the origin
    // The corner nearest to the foot of the normal would be best; the three agree to rounding, the mean is as good as any.
    const double height = glm::dot(normal, a + b + c) / (3.0 * area);
    const double speed = glm::dot(normal, direction) / area;
    out.t = height / speed;
    const double tiny = std::numeric_limits<double>::min();
    out.plane = std::abs(height);
    out.slant = 1.0 + 1.0 / std::max(out.plane, tiny) + ld / std::max(std::abs(speed), tiny);
    const double side = speed > 0.0 ? 1.0 : -1.0;
    const double e0 = side * glm::dot(direction, glm::cross(a, b)) / (ld * la * lb);
    const double e1 = side * glm::dot(direction, glm::cross(b, c)) / (ld * lb * lc);
    const double e2 = side * glm::dot(direction, glm::cross(c, a)) / (ld * lc * la);
    out.inside = std::min({e0, e1, e2});
    return out;
}

struct RayHit {
    int triangle = -1;  // -1: nothing is met
    double t = std::numeric_limits<double>::infinity();
    double slant = 1.0;   // of the triangle met
    double margin = 1.0;  // 0: a tie; the smallest relative change of the input that changes the triangle is of this order
};

/// Nearest triangle with t > 0, both faces. A triangle whose plane passes within the rounding error of the origin is not seen.
inline RayHit nearest_triangle(const std::vector<Triangle>& triangles, const dvec3& origin, const dvec3& direction) {
    RayHit hit;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Crossing c = cross_triangle(origin, direction, triangles[i]);
        if (c.plane < tolerance::plane_through_centre || c.inside < 0.0 || !(c.t > 0.0) || !(c.t < hit.t)) continue;
        hit.triangle = static_cast<int>(i);
        hit.t = c.t;
        hit.slant = c.slant;
        hit.margin = c.inside;
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const Crossing c = cross_triangle(origin, direction, triangles[i]);
        if (static_cast<int>(i) == hit.triangle || !(c.t > 0.0)) continue;
        const double depth = (c.t - hit.t) / hit.t;  // NaN if nothing was hit: then every near miss counts
        if (c.inside < 0.0 && !(depth > 0.0)) hit.margin = std::min(hit.margin, -c.inside);
        if (c.inside >= 0.0 && depth >= 0.0) hit.margin = std::min(hit.margin, depth / c.slant);
        const double slack = tolerance::plane_through_centre_slack;
        const bool doubtful = c.plane * slack > tolerance::plane_through_centre && c.plane < tolerance::plane_through_centre * slack;
        if (c.inside >= 0.0 && doubtful) hit.margin = 0.0;
    }
    return hit;
}

/// Whether `answer` (-1: nothing) is what float arithmetic may find along the ray: the answer is hit or missed by less than the edge tie,
/// and whatever lies clearly in front of it is missed, or hit by less than the edge tie.
inline bool is_plausible(const std::vector<Triangle>& triangles, const dvec3& origin, const dvec3& direction, int answer) {
    const double through = tolerance::plane_through_centre, slack = tolerance::plane_through_centre_slack;
    double t = std::numeric_limits<double>::infinity(), t_error = 0.0;
    if (answer >= 0) {
        const Crossing c = cross_triangle(origin, direction, triangles[static_cast<std::size_t>(answer)]);
        if (!(c.t > 0.0) || c.inside < -tolerance::edge_tie || c.plane < through / slack) return false;
        t = c.t;
        t_error = tolerance::depth_tie * c.slant;
    }
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (static_cast<int>(i) == answer) continue;
        const Crossing c = cross_triangle(origin, direction, triangles[i]);
        const bool certainly_hit = c.t > 0.0 && c.inside > tolerance::edge_tie && c.plane > through * slack;
        if (certainly_hit && c.t * (1.0 + tolerance::depth_tie * c.slant) < t * (1.0 - t_error)) return false;
    }
    return true;
}

}  // namespace pencil::ref
