// Built-in shapes. Rectangle and cube are flat and carry no vertex normals; the sphere carries its exact ones.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "scene/meshes/mesh.h"

namespace pencil {
namespace {

/// Index of the point midway between vertices a and b on the sphere, made once per edge so that the mesh stays closed.
std::uint32_t midpoint(std::uint32_t a, std::uint32_t b, Mesh& mesh,
                       std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>& made) {
    const auto [place, is_new] = made.emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
    return place->second;
}

Mesh make_icosahedron() {
    const double t = (1.0 + std::sqrt(5.0)) / 2.0;  // golden ratio: the corners of three perpendicular golden rectangles
    Mesh mesh;
    for (const glm::dvec3 corner : {glm::dvec3(-1, t, 0),
                                    {1, t, 0},
                                    {-1, -t, 0},
                                    {1, -t, 0},
                                    {0, -1, t},
                                    {0, 1, t},
                                    {0, -1, -t},
                                    {0, 1, -t},
                                    {t, 0, -1},
                                    {t, 0, 1},
                                    {-t, 0, -1},
                                    {-t, 0, 1}}) {
        mesh.positions.push_back(glm::normalize(corner));
    }
    mesh.triangles = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return mesh;
}

}  // namespace

Mesh make_rectangle() {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Mesh make_cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) mesh.positions.emplace_back((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
    const std::array<std::array<std::uint32_t, 4>, 6> faces = {
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};  // -x +x -y +y -z +z, seen from outside
    for (const auto& f : faces) {
        mesh.triangles.emplace_back(f[0], f[1], f[2]);
        mesh.triangles.emplace_back(f[0], f[2], f[3]);
    }
    return mesh;
}

Mesh make_sphere() {
    constexpr int divisions = 3;
    Mesh mesh = make_icosahedron();
    for (int level = 0; level < divisions; ++level) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> made;
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3 t : mesh.triangles) {
            const std::uint32_t xy = midpoint(t.x, t.y, mesh, made), yz = midpoint(t.y, t.z, mesh, made),
                                zx = midpoint(t.z, t.x, mesh, made);
            finer.insert(finer.end(), {{t.x, xy, zx}, {xy, t.y, yz}, {zx, yz, t.z}, {xy, yz, zx}});
        }
        mesh.triangles = std::move(finer);
    }
    mesh.normals = mesh.positions;
    return mesh;
}

}  // namespace pencil
