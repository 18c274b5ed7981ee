// A mesh in its own coordinates, as a file or a built-in shape gives it, and the step that places it in a scene.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace pencil {

/// Counter-clockwise triangles seen from the front.
struct Mesh {
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;  // as many as positions, or none; a zero vector means none for that vertex
    std::vector<glm::vec2> uvs;       // texture coordinates, as many as positions, or none
    std::vector<glm::vec3> colours;   // linear, as many as positions, or none
    std::vector<glm::uvec3> triangles;
    bool smooth = false;             // placing the mesh computes its vertex normals if it has none
    std::vector<std::string> notes;  // what the file has and the mesh has not, for warnings
    // Of an OBJ:
    std::vector<std::uint32_t> material;  // of each triangle: index into materials; or none
    std::vector<std::string> materials;   // as usemtl names them, "" before the first
    std::vector<std::string> libraries;   // operands of mtllib
};

struct MeshPlacement {
    glm::dmat4 to_world{1.0};
    bool flip_normals = false;  // turns front to back
    bool face_normals = false;  // drops the mesh's normals, given or computed
};

constexpr std::size_t max_triangles = std::size_t{1} << 26;  // of a scene: beyond any that fits a device's memory with its maps

/// What placing a mesh did to its triangles.
struct PlacementCounts {
    std::size_t dropped = 0;  // of zero area
    std::size_t turned = 0;   // wound against their vertex normals, and so turned round
};

/// Whose triangles these are: indices into Scene::shapes and Scene::materials.
struct Owner {
    std::uint32_t shape = 0, material = 0;
};

/// Appends the mesh, transformed, to the scene's arrays as triangles of `owner`. The side of the transformed normal stays the front, under
/// mirroring too. Vertices that no kept triangle uses are left out. `where` is blamed for coordinates out of range.
PlacementCounts place_mesh(const Mesh& mesh, const MeshPlacement& placement, Owner owner, const std::string& where, Scene& scene);

// Built-in shapes have the texture coordinates of Mitsuba's.

/// [-1, 1]^2 at z = 0, front towards +z.
Mesh make_rectangle();
/// [-1, 1]^3, fronts outward.
Mesh make_cube();
/// Unit sphere as an icosahedron divided so often, at least once: 20 * 4^divisions triangles with vertices on the sphere and its normals. At 3
/// divisions the flat triangles have 0.5 % less area than the sphere and lie up to 0.5 % of the radius inside it, four times that with each
/// division less. uv: longitude / (2 pi) from +x over +y, colatitude from +z / pi; triangles across the seam have u beyond 1, and a corner on a
/// pole has the mean u of the other two.
Mesh make_sphere(int divisions);
/// Unit disk at z = 0 of 128 triangles, front towards +z, 0.04 % less in area than the round one. uv: distance from the centre, angle / (2 pi).
Mesh make_disk();
/// Unit radius around the z axis from z = 0 to 1, open, of 256 triangles with the normals of the round one, fronts outward. uv: angle / (2 pi), z.
Mesh make_cylinder();

}  // namespace pencil
