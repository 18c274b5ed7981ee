// Disk and cylinder, in flat triangles.
#include <cmath>

#include "scene/meshes/mesh.h"
#include "util/constants.h"

namespace pencil {
namespace {

constexpr int segments = 128;

/// Exact at quarter turns, so that shapes meet there.
glm::dvec3 on_circle(int i) {
    const int quarter = segments / 4, turned = i % segments;
    const double angle = 2 * pi * (turned % quarter) / segments;
    const double c = std::cos(angle), s = std::sin(angle);
    switch (turned / quarter) {
        case 0:
            return {c, s, 0};
        case 1:
            return {-s, c, 0};
        case 2:
            return {-c, -s, 0};
        default:
            return {s, -c, 0};
    }
}

float turn(double i) { return static_cast<float>(i / segments); }

}  // namespace

/// A centre for each triangle: the angle in the texture coordinates has no value there.
Mesh make_disk() {
    Mesh mesh;
    for (int i = 0; i <= segments; ++i) {
        mesh.positions.push_back(on_circle(i));
        mesh.uvs.emplace_back(1.0F, turn(i));
    }
    for (int i = 0; i < segments; ++i) {
        mesh.positions.emplace_back(0.0);
        mesh.uvs.emplace_back(0.0F, turn(i + 0.5));
        const auto rim = static_cast<std::uint32_t>(i);
        mesh.triangles.emplace_back(rim, rim + 1, static_cast<std::uint32_t>(segments + 1) + rim);
    }
    return mesh;
}

Mesh make_cylinder() {
    Mesh mesh;
    for (int i = 0; i <= segments; ++i) {
        for (int z = 0; z < 2; ++z) {
            mesh.positions.push_back(on_circle(i) + glm::dvec3(0, 0, z));
            mesh.normals.push_back(on_circle(i));
            mesh.uvs.emplace_back(turn(i), static_cast<float>(z));
        }
    }
    for (std::uint32_t i = 0; i < 2 * segments; i += 2) {
        mesh.triangles.emplace_back(i, i + 2, i + 3);
        mesh.triangles.emplace_back(i, i + 3, i + 1);
    }
    return mesh;
}

}  // namespace pencil
