// Texture coordinates on their way from meshes and built-in shapes into a scene: one per position, where Mitsuba has them.
#include <glm/geometric.hpp>
#include <set>
#include <tuple>

#include "scene/meshes/mesh.h"
#include "scene/meshes/read_obj.h"
#include "scene/meshes/read_ply.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

using TextureCoordinates = SceneTest;

TEST(TextureCoordinatesOfShapes, RectangleAndCubeAreMitsubas) {
    const Mesh rectangle = make_rectangle();
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(glm::dvec2(rectangle.uvs.at(i)), 0.5 * (glm::dvec2(rectangle.positions[i]) + 1.0));
    const Mesh cube = make_cube();
    ASSERT_EQ(cube.uvs.size(), 24U);
    const auto uv = [&](const glm::dvec3& position, const glm::dvec3& normal) {
        for (const glm::uvec3 t : cube.triangles) {
            const glm::dvec3 face = glm::cross(cube.positions[t.y] - cube.positions[t.x], cube.positions[t.z] - cube.positions[t.x]);
            for (int k = 0; k < 3; ++k)
                if (cube.positions[t[k]] == position && glm::dot(face, normal) > 0) return cube.uvs[t[k]];
        }
        return glm::vec2(-1.0F);
    };
    // Two corners of each side, by Mitsuba's table of vertices.
    EXPECT_EQ(uv({1, -1, -1}, {0, -1, 0}), glm::vec2(0, 1));
    EXPECT_EQ(uv({1, -1, 1}, {0, -1, 0}), glm::vec2(1, 1));
    EXPECT_EQ(uv({1, 1, -1}, {0, 1, 0}), glm::vec2(0, 1));
    EXPECT_EQ(uv({-1, 1, -1}, {0, 1, 0}), glm::vec2(1, 1));
    EXPECT_EQ(uv({1, -1, -1}, {1, 0, 0}), glm::vec2(0, 1));
    EXPECT_EQ(uv({1, 1, -1}, {1, 0, 0}), glm::vec2(1, 1));
    EXPECT_EQ(uv({1, -1, 1}, {0, 0, 1}), glm::vec2(0, 1));
    EXPECT_EQ(uv({1, 1, 1}, {0, 0, 1}), glm::vec2(1, 1));
    EXPECT_EQ(uv({-1, -1, 1}, {-1, 0, 0}), glm::vec2(0, 1));
    EXPECT_EQ(uv({-1, 1, 1}, {-1, 0, 0}), glm::vec2(1, 1));
    EXPECT_EQ(uv({1, 1, -1}, {0, 0, -1}), glm::vec2(0, 1));
    EXPECT_EQ(uv({1, -1, -1}, {0, 0, -1}), glm::vec2(1, 1));
}

/// u is the longitude and v the colatitude everywhere, and no triangle spans more than its share of either.
TEST(TextureCoordinatesOfShapes, SphereHasNoTriangleAcrossTheSeam) {
    const Mesh sphere = make_sphere(3);
    ASSERT_EQ(sphere.uvs.size(), sphere.positions.size());
    ASSERT_EQ(sphere.normals.size(), sphere.positions.size());
    std::set<std::tuple<double, double, double>> places;
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        const glm::dvec3 p = sphere.positions[i];
        const double phi = 2 * M_PI * sphere.uvs[i].x, theta = M_PI * sphere.uvs[i].y;
        ASSERT_LT(glm::distance(p, {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}), 1e-6);
        EXPECT_EQ(sphere.normals[i], p);
        places.insert({p.x, p.y, p.z});
    }
    EXPECT_EQ(places.size(), 642U);  // 12 corners and one on each of the edges divided
    for (const glm::uvec3 t : sphere.triangles) {
        const auto [low, high] = std::minmax({sphere.uvs[t.x].x, sphere.uvs[t.y].x, sphere.uvs[t.z].x});
        EXPECT_LT(high - low, 0.26F) << "a quarter at the poles, less elsewhere";
        EXPECT_GE(low, 0.0F);
    }
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0 0.5\nvt 0.25 0.75\nvt 0.5\n";

TEST(TextureCoordinatesOfMeshes, Obj) {
    const Mesh mesh = read_obj(square + "f 1/1 2/2 3/3\nf 1/4 3/3 4", "m.obj");
    ASSERT_EQ(mesh.uvs.size(), 5U);  // corner 1 has two
    EXPECT_EQ(mesh.uvs[mesh.triangles[0].y], glm::vec2(1, 0));
    EXPECT_EQ(mesh.uvs[mesh.triangles[0].z], glm::vec2(0.25F, 0.75F));
    EXPECT_EQ(mesh.uvs[mesh.triangles[1].x], glm::vec2(0.5F, 0));
    EXPECT_EQ(mesh.triangles[1].y, mesh.triangles[0].z);
    EXPECT_EQ(mesh.uvs[mesh.triangles[1].z], glm::vec2(0, 0));  // none given
    EXPECT_TRUE(read_obj(square + "f 1 2 3", "m.obj").uvs.empty());
    // Given normals stay what they are where texture coordinates split a vertex.
    const Mesh split = read_obj(square + "vn 0 0 1\nf 1/1/1 2/2/1 3/3/1\nf 1/4/1 3/3/1 4//1", "m.obj");
    ASSERT_EQ(split.positions.size(), 5U);
    for (const glm::dvec3& normal : split.normals) EXPECT_EQ(normal, glm::dvec3(0, 0, 1));
    for (const char* line : {"vt\n", "vt nan 0\n", "vt 0 x\n", "vt 0 0 0 0\n"})
        EXPECT_NO_THROW(read_obj(square + line, "m.obj")) << line << "what is no number is 0: no mesh is refused for it";
}

std::string ply(const std::string& u, const std::string& v, const std::string& first_row = "0 0 0 0.25 0.75\n") {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float " + u +
           "\nproperty float " + v + "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" + first_row +
           "1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n";
}

TEST(TextureCoordinatesOfMeshes, PlyByAnyOfItsNames) {
    using Names = std::pair<const char*, const char*>;
    for (const auto& [u, v] : {Names{"u", "v"}, Names{"s", "t"}, Names{"texture_u", "texture_v"}, Names{"texture_s", "texture_t"}}) {
        const Mesh mesh = read_ply(ply(u, v), "m.ply");
        ASSERT_EQ(mesh.uvs.size(), 3U) << u;
        EXPECT_EQ(mesh.uvs[0], glm::vec2(0.25F, 0.75F));
    }
    EXPECT_TRUE(read_ply(ply("u", "t"), "m.ply").uvs.empty());
}

TEST_F(TextureCoordinates, OnePerPositionOfTheScene) {
    write("m.obj", square + "f 1/1 2/2 3/3\n");
    write("plain.obj", square + "f 1 2 3\n");
    write("m.ply", ply("u", "v"));
    const auto mesh = [](const std::string& file, const std::string& inside = "") {
        return "<shape type=\"" + file.substr(file.size() - 3) + "\"><string name=\"filename\" value=\"" + file + "\"/>" + inside +
               "</shape>";
    };
    EXPECT_TRUE(load_body(mesh("plain.obj")).uvs.empty());
    const Scene scene = load_body(mesh("plain.obj") + mesh("m.obj") + mesh("m.ply") + mesh("plain.obj"));
    ASSERT_EQ(scene.positions.size(), 12U);
    ASSERT_EQ(scene.uvs.size(), 12U);
    EXPECT_EQ(scene.uvs[2], glm::vec2(0.0F));
    EXPECT_EQ(scene.uvs[5], glm::vec2(0.25F, 0.25F));  // OBJ counts v downwards (Mitsuba's flip_tex_coords)
    EXPECT_EQ(scene.uvs[6], glm::vec2(0.25F, 0.75F));
    EXPECT_EQ(scene.uvs[11], glm::vec2(0.0F));
    const std::string flip = "<boolean name=\"flip_tex_coords\" value=\"";
    EXPECT_EQ(load_body(mesh("m.obj", flip + "false\"/>")).uvs[2], glm::vec2(0.25F, 0.75F));
    EXPECT_EQ(load_body(mesh("m.ply", flip + "true\"/>")).uvs[0], glm::vec2(0.25F, 0.25F));
}

/// Computed normals see the positions, not the texture: a PLY roof is round whether it has texture coordinates or not.
TEST_F(TextureCoordinates, ComputedNormalsAreThoseWithoutThem) {
    const auto roof = [](bool uv) {
        const std::string columns = uv ? "property float u\nproperty float v\n" : "", end = uv ? " 0.5 0.5\n" : "\n";
        return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n" + columns +
               "element face 2\nproperty list uchar int vertex_indices\nend_header\n0 1 0" + end + "0 1 1" + end + "1 0 0" + end +
               "-1 0 0" + end + "3 0 1 2\n3 0 3 1\n";
    };
    write("with.ply", roof(true));
    write("without.ply", roof(false));
    const Scene scene = load_body(
        "<shape type=\"ply\"><string name=\"filename\" value=\"with.ply\"/></shape>"
        "<shape type=\"ply\"><string name=\"filename\" value=\"without.ply\"/></shape>");
    ASSERT_EQ(scene.normals.size(), 8U);
    EXPECT_NE(scene.normals[0], glm::vec3(0.0F));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(scene.normals[i], scene.normals[i + 4]);
}

}  // namespace
}  // namespace pencil::test
