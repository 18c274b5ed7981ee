// Computed vertex normals: angle weights by hand, flat meshes stay flat, face_normals and texture seams split, transforms and mirrors.
#include <cmath>
#include <glm/geometric.hpp>

#include "scene/meshes/vertex_normals.h"
#include "unit/scene_fixture.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A cube's corner: the three faces meet there at right angles, one of them split into two triangles of 45 degrees.
const std::vector<glm::dvec3> corner_positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
const std::vector<glm::uvec3> corner_triangles = {{0, 3, 2}, {0, 1, 3}, {0, 2, 4}, {0, 4, 1}};  // -x, -y, -z, -z

TEST(VertexNormals, AreWeightedByAngle) {
    const std::vector<glm::dvec3> normals = smooth_normals(corner_positions, corner_triangles);
    EXPECT_LT(glm::length(normals[0] - glm::dvec3(-1, -1, -1) / std::sqrt(3.0)), 1e-12);
    EXPECT_LT(glm::length(normals[4] - glm::dvec3(0, 0, -1)), 1e-12);
    // Vertex 1: 45 degrees of -y (its triangle is half a square) and 90 of -z.
    EXPECT_LT(glm::length(normals[1] - glm::normalize(glm::dvec3(0, -1, -2))), 1e-12);
}

TEST(VertexNormals, DoNotDependOnUnitsAndSkipDegenerateTriangles) {
    const std::vector<glm::dvec3> expected = smooth_normals(corner_positions, corner_triangles);
    for (const double unit : {1e-100, 1e17}) {
        std::vector<glm::dvec3> positions = corner_positions;
        for (glm::dvec3& p : positions) p *= unit;
        positions.emplace_back(0.0);
        std::vector<glm::uvec3> triangles = corner_triangles;
        triangles.emplace_back(0, 5, 1);  // two corners in one place
        triangles.emplace_back(5, 5, 5);
        const std::vector<glm::dvec3> normals = smooth_normals(positions, triangles);
        for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_LT(glm::length(normals[i] - expected[i]), 1e-12) << unit << " " << i;
        EXPECT_EQ(normals[5], glm::dvec3(0.0));
    }
}

TEST(VertexNormals, FlatAndBentMeshesAreToldApart) {
    const std::vector<glm::uvec3> flat = {corner_triangles[2], corner_triangles[3]};
    EXPECT_TRUE(are_face_normals(smooth_normals(corner_positions, flat), corner_positions, flat, 1e-12));
    EXPECT_FALSE(are_face_normals(smooth_normals(corner_positions, corner_triangles), corner_positions, corner_triangles, 1e-6));
}

class SmoothMeshes : public SceneTest {
protected:
    static std::string shape(const std::string& kind, const std::string& more = "") {
        return "<shape type=\"" + kind + "\"><string name=\"filename\" value=\"roof." + kind + "\"/>" + more + "</shape>\n";
    }
    /// Normals of the two vertices of a roof's ridge: zero if the roof is flat shaded.
    glm::vec3 ridge(const std::string& body) const {
        const Scene scene = load_body(body);
        for (std::size_t i = 0; i < scene.positions.size(); ++i)
            if (std::abs(scene.positions[i].y) > 0.5) return scene.normals[i];
        ADD_FAILURE() << "no ridge";
        return {};
    }
};

/// Two squares of slope 45 degrees that meet in the ridge y = 1; fronts upwards.
const std::string roof_obj = "v -1 0 0\nv -1 0 1\nv 0 1 1\nv 0 1 0\nv 1 0 1\nv 1 0 0\n";

TEST_F(SmoothMeshes, FilesWithoutNormalsAreSmoothed) {
    write("roof.obj", roof_obj + "f 1 2 3 4\nf 4 3 5 6\n");
    write("roof.ply",
          "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
          "property list uchar int vertex_indices\nend_header\n-1 0 0\n-1 0 1\n0 1 1\n0 1 0\n1 0 1\n1 0 0\n4 0 1 2 3\n4 3 2 4 5\n");
    for (const char* kind : {"obj", "ply"}) {
        const glm::vec3 normal = ridge(shape(kind));
        EXPECT_NEAR(normal.y, 1.0F, 1e-6F) << kind;  // by symmetry: both slopes have 90 degrees at the ridge
        EXPECT_EQ(ridge(shape(kind, "<boolean name=\"face_normals\" value=\"true\"/>")), glm::vec3(0.0F)) << kind;
        EXPECT_LT(ridge(shape(kind, "<boolean name=\"flip_normals\" value=\"true\"/>")).y, -0.9F) << kind;
        EXPECT_LT(ridge(shape(kind, "<transform name=\"to_world\"><scale y=\"-1\"/></transform>")).y, -0.9F) << kind;
    }
}

TEST_F(SmoothMeshes, GivenNormalsAndTextureSeamsStay) {
    write("roof.obj", roof_obj + "vn 0 0 1\nf 1 2 3 4\nf 4 3//1 5 6\n");  // any normal in the file: none is computed
    EXPECT_EQ(ridge(shape("obj")), glm::vec3(0.0F));
    write("roof.obj", roof_obj + "vt 0 0\nvt 1 1\nf 1/1 2/1 3/1 4/1\nf 4/2 3/2 5/2 6/2\n");
    EXPECT_EQ(ridge(shape("obj")), glm::vec3(0.0F));  // the seam makes two flat squares
}

}  // namespace
