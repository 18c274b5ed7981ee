// Hemispherical Voronoi cells of directions, by brute force in double precision.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "reference/octahedral_ref.h"

namespace pencil::ref {

/// Tangents of a unit normal (Duff et al. 2017); with them the direction (x, y, z) of a frame is x t + y b + z n.
struct Frame {
    dvec3 t, b, n;
    explicit Frame(const dvec3& normal) : n(normal) {
        const double s = std::copysign(1.0, n.z), k = -1.0 / (s + n.z), m = n.x * n.y * k;
        t = {1.0 + s * n.x * n.x * k, s * m, -s * n.x};
        b = {m, s + n.y * n.y * k, -n.y};
    }
    dvec3 to_world(const dvec3& v) const { return v.x * t + v.y * b + v.z * n; }
};

/// Pencils that may be called the nearest to `sample`: those within `slack` of the smallest 1 - cos, relative to it and absolute.
inline std::vector<std::size_t> nearest_directions(const dvec3& sample, const std::vector<dvec3>& directions,
                                                   const std::vector<bool>& visible, double relative = 0.0, double absolute = 0.0) {
    double nearest = 3.0;
    for (std::size_t i = 0; i < directions.size(); ++i)
        if (visible[i]) nearest = std::min(nearest, 1.0 - glm::dot(sample, directions[i]));
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < directions.size(); ++i)
        if (visible[i] && 1.0 - glm::dot(sample, directions[i]) <= nearest * (1.0 + relative) + absolute) out.push_back(i);
    return out;
}

/// Cosine-weighted solid angle of every cell about `normal`, from `samples` directions of a spiral of equal cosine-weighted solid angles.
inline std::vector<double> cell_weights(const dvec3& normal, const std::vector<dvec3>& directions, const std::vector<bool>& visible,
                                        int samples) {
    std::vector<double> weights(directions.size(), 0.0);
    const Frame frame(normal);
    const double golden = pi * (3.0 - std::sqrt(5.0));
    for (int k = 0; k < samples; ++k) {
        const double r2 = (k + 0.5) / samples, r = std::sqrt(r2);
        const dvec3 sample = frame.to_world({r * std::cos(golden * k), r * std::sin(golden * k), std::sqrt(1.0 - r2)});
        const std::vector<std::size_t> nearest = nearest_directions(sample, directions, visible);
        if (!nearest.empty()) weights[nearest.front()] += pi / samples;
    }
    return weights;
}

/// The cell of the first of two directions: the half of the hemisphere on its side of the bisecting plane, pi/2 (1 + cos), the angle
/// between the normals of surface and plane.
inline double first_of_two(const dvec3& normal, const dvec3& first, const dvec3& second) {
    return 0.5 * pi * (1.0 + glm::dot(normal, glm::normalize(first - second)));
}

}  // namespace pencil::ref
