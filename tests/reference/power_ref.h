// Cells of a power diagram of directions, by brute force in double precision.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "reference/octahedral_ref.h"

namespace pencil::ref {

/// A direction in which light is known, about a surface point.
struct PowerSite {
    dvec3 direction, light;
    double density;  // of the directions about it per solid angle
};

/// Half the square of the radius of its cell's disc: an area of 1.25 directions, at most four of the mean cell of `rays` rays.
inline double disc_radius(double density, int rays) { return 0.5 * std::min(1.25 / (pi * density), 4.0 / rays); }

/// Density of lines through `pencils` centres that are uniform in `volume`, of free paths d, and of `rays` rays by the cosine.
inline double line_and_ray_density(double d, double cosine, int pencils, double volume, int rays) {
    return pencils * d * d * d / (3.0 * volume) + rays * cosine / pi;
}

/// Least and greatest light of those sites that may be called the nearest to `sample`: within `slack` of the smallest power distance.
struct LightRange {
    dvec3 low{1e9}, high{0.0};
};
inline LightRange nearest_light(const dvec3& sample, const std::vector<PowerSite>& sites, int rays, double slack) {
    const auto distance = [&](const PowerSite& s) { return 1.0 - glm::dot(sample, s.direction) - disc_radius(s.density, rays); };
    double nearest = 1e9;
    for (const PowerSite& s : sites) nearest = std::min(nearest, distance(s));
    LightRange out;
    for (const PowerSite& s : sites) {
        if (distance(s) > nearest + slack) continue;
        out.low = glm::min(out.low, s.light);
        out.high = glm::max(out.high, s.light);
    }
    return out;
}

}  // namespace pencil::ref
