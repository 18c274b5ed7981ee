// Built-in shapes. Rectangle and cube are flat and carry no vertex normals; the sphere carries its exact ones. Corners of one place are one
// vertex as far as their texture coordinates agree.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "scene/meshes/mesh.h"
#include "util/constants.h"

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
                                    {-t, 0, 1}})
        mesh.positions.push_back(glm::normalize(corner));
    mesh.triangles = {{0, 11, 5}, {0, 5, 1}, {0, 1, 7}, {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2}, {3, 2, 6}, {3, 6, 8},  {3, 8, 9},   {4, 9, 5}, {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return mesh;
}

/// Texture coordinates of a triangle of the sphere, so that they are linear over it as nearly as can be.
std::array<glm::vec2, 3> spherical_uvs(const glm::dvec3 (&corners)[3]) {
    constexpr double at_pole = 1e-9;
    double u[3], mean = 0;
    bool pole[3];
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        pole[k] = std::hypot(corners[k].x, corners[k].y) < at_pole;
        u[k] = std::atan2(corners[k].y, corners[k].x) / (2 * pi);
        if (u[k] < 0) u[k] += 1;
    }
    double highest = 0;
    for (int k = 0; k < 3; ++k)
        if (!pole[k]) highest = std::max(highest, u[k]);
    for (int k = 0; k < 3; ++k) {
        if (pole[k]) continue;
        if (highest - u[k] > 0.5) u[k] += 1;  // on the other side of the seam
        mean += u[k];
        ++count;
    }
    std::array<glm::vec2, 3> uvs;
    for (std::size_t k = 0; k < 3; ++k)
        uvs[k] = glm::vec2(pole[k] ? mean / count : u[k], std::acos(std::clamp(corners[k].z, -1.0, 1.0)) / pi);
    return uvs;
}

/// Splits the vertices whose texture coordinates are not the same in all triangles around.
void add_spherical_uvs(Mesh& mesh) {
    std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> made;
    Mesh split;
    for (glm::uvec3& t : mesh.triangles) {
        const auto uvs = spherical_uvs({mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z]});
        for (int k = 0; k < 3; ++k) {
            const glm::vec2 uv = uvs[static_cast<std::size_t>(k)];
            const auto [place, is_new] = made.emplace(std::tuple(t[k], uv.x, uv.y), static_cast<std::uint32_t>(split.positions.size()));
            if (is_new) {
                split.positions.push_back(mesh.positions[t[k]]);
                split.normals.push_back(mesh.normals[t[k]]);
                split.uvs.push_back(uv);
            }
            t[k] = place->second;
        }
    }
    split.triangles = std::move(mesh.triangles);
    mesh = std::move(split);
}

}  // namespace

Mesh make_rectangle() {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

Mesh make_cube() {
    struct Side {
        std::array<int, 4> corners;  // seen from outside; bit k of a corner: +1 along axis k
        glm::dvec3 u, v;             // directions in which the texture coordinates grow from 0 to 1
    };
    const std::array<Side, 6> sides = {{{{0, 4, 6, 2}, {0, 1, 0}, {0, 0, 1}},
                                        {{1, 3, 7, 5}, {0, 1, 0}, {0, 0, -1}},
                                        {{0, 1, 5, 4}, {0, 0, 1}, {1, 0, 0}},
                                        {{2, 6, 7, 3}, {-1, 0, 0}, {0, 0, -1}},
                                        {{0, 2, 3, 1}, {0, -1, 0}, {1, 0, 0}},
                                        {{4, 5, 7, 6}, {0, 1, 0}, {1, 0, 0}}}};  // -x +x -y +y -z +z
    Mesh mesh;
    for (const Side& side : sides) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const int i : side.corners) {
            const glm::dvec3 corner((i & 1) != 0 ? 1 : -1, (i & 2) != 0 ? 1 : -1, (i & 4) != 0 ? 1 : -1);
            mesh.positions.push_back(corner);
            mesh.uvs.emplace_back((1 + glm::dot(corner, side.u)) / 2, (1 + glm::dot(corner, side.v)) / 2);
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
    return mesh;
}

Mesh make_sphere(int divisions) {
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
    add_spherical_uvs(mesh);
    return mesh;
}

}  // namespace pencil
