// Random test data that is the same on every platform: a seed names it for ever.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "reference/raycast_ref.h"

namespace pencil::ref {

class Random {
public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}

    double uniform() { return (static_cast<double>(engine_()) + 0.5) / 4294967296.0; }  // (0, 1)
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    int index(int count) { return static_cast<int>(uniform() * count); }
    dvec3 in_box(double low, double high) {
        const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
        return {x, y, z};
    }
    dvec3 direction() {
        for (;;) {
            const dvec3 v = in_box(-1.0, 1.0);
            const double r = glm::length(v);
            if (r > 0.1 && r < 1.0) return v / r;
        }
    }

private:
    std::mt19937 engine_;
};

/// The nearest float, as a double: inputs that kernel and reference read alike.
inline dvec3 as_float(const dvec3& v) {
    return {static_cast<double>(static_cast<float>(v.x)), static_cast<double>(static_cast<float>(v.y)),
            static_cast<double>(static_cast<float>(v.z))};
}

/// Triangles thrown into the cube [-1, 1]^3, sizes from 0.02 to 1.5, corners exact floats. Each has its own plane.
inline std::vector<Triangle> triangle_soup(Random& random, int count) {
    std::vector<Triangle> soup;
    for (int i = 0; i < count; ++i) {
        const dvec3 centre = random.in_box(-0.9, 0.9);
        const double size = 0.02 * std::pow(75.0, random.uniform());
        Triangle t;
        for (dvec3* corner : {&t.v0, &t.v1, &t.v2}) *corner = as_float(glm::clamp(centre + size * random.direction(), -1.0, 1.0));
        t.plane = i;
        soup.push_back(t);
    }
    return soup;
}

}  // namespace pencil::ref
