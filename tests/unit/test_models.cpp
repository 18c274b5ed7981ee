// OBJ with its materials, and PLY, opened as scenes.
#include <cmath>
#include <glm/geometric.hpp>

#include "unit/gltf_fixture.h"

namespace pencil::test {
namespace {

class Models : public GltfTest {
protected:
    static constexpr const char* square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

    Scene obj(const std::string& text) const { return load_scene(write("m.obj", text)); }
    /// A square of the one material that the library has.
    Scene of_material(const std::string& statements) const {
        write("m.mtl", "newmtl a\n" + statements);
        return obj("mtllib m.mtl\n" + std::string(square) + "usemtl a\nf 1/1 2/2 3/3 4/4\n");
    }
    SceneMaterial material(const std::string& statements) const {
        const Scene scene = of_material(statements);
        return scene.materials.at(scene.triangles.at(0).material);
    }
};

TEST_F(Models, AFramedGreySquareUnderASky) {
    const Scene scene = obj(std::string(square) + "f 1 2 3 4\n");
    ASSERT_EQ(scene.shapes.size(), 1U);
    EXPECT_EQ(scene.triangles.size(), 2U);
    EXPECT_EQ(scene.materials.at(0).model, MATERIAL_DIFFUSE);
    EXPECT_TRUE(scene.materials.at(0).two_sided);
    EXPECT_TRUE(has_warning(scene, "there is no camera"));
    EXPECT_TRUE(has_warning(scene, "there is no light"));
    EXPECT_TRUE(scene.environment);
}

TEST_F(Models, FacesOfOneMaterialAreOneShape) {
    write("m.mtl", "newmtl red\nKd 1 0 0\nnewmtl lamp\nKe 3 2 1\n");
    const Scene scene = obj("mtllib m.mtl\n" + std::string(square) +
                            "f 1 2 3\nusemtl red\nf 1 2 4\nusemtl lamp\nf 1 3 4\nusemtl red\nf 2 3 4\nusemtl unknown\nf 1 2 3 4\n");
    ASSERT_EQ(scene.shapes.size(), 4U);
    EXPECT_EQ(scene.shapes[0].id, "obj");
    EXPECT_EQ(scene.shapes[1].id, "red");
    EXPECT_EQ(scene.shapes[1].triangle_count, 2U);
    EXPECT_EQ(scene.materials.at(scene.triangles[1].material).albedo, glm::vec3(1, 0, 0));
    EXPECT_TRUE(scene.shapes[2].emits);
    EXPECT_EQ(scene.shapes[2].radiance, glm::vec3(3, 2, 1));
    EXPECT_FALSE(scene.environment);
    EXPECT_TRUE(has_warning(scene, "material \"unknown\" is in no library"));
    EXPECT_EQ(scene.triangles.size(), 6U);
    for (const Triangle3& t : scene.triangles)
        for (int k = 0; k < 3; ++k) EXPECT_LT(t.corners[k], scene.positions.size());
}

TEST_F(Models, LibrariesThatCannotBeReadAreLeftOut) {
    for (const char* name : {"nothing.mtl", "../m.mtl", "/etc/passwd", "C:\\m.mtl"}) {
        const Scene scene = obj("mtllib " + std::string(name) + "\n" + square + "f 1 2 3\n");
        EXPECT_TRUE(has_warning(scene, "its materials are left out")) << name;
    }
    write("sub/m m.mtl", "newmtl a\nKd 0 1 0\n");
    const Scene scene = obj("mtllib sub\\m m.mtl\n" + std::string(square) + "usemtl a\nf 1 2 3\n");
    EXPECT_EQ(scene.materials.at(0).albedo, glm::vec3(0, 1, 0));
}

TEST_F(Models, ModelsOfIllumination) {
    EXPECT_EQ(material("Kd 0.2 0.4 0.6\nKs 0 0 0\n").model, MATERIAL_DIFFUSE);
    EXPECT_EQ(material("Kd 0.5\nKs 0.5 0.5 0.5\nillum 1\n").model, MATERIAL_DIFFUSE);
    const SceneMaterial glossy = material("Kd 0.2 0.4 0.6\nKs 0.5 0.5 0.5\nNs 30\nillum 2\n");
    EXPECT_EQ(glossy.model, MATERIAL_PRINCIPLED);
    EXPECT_NEAR(glossy.alpha.x, 0.5F, 1e-6);
    EXPECT_NEAR(glossy.eta.x, 1.5F, 1e-6);
    const SceneMaterial mirror = material("Kd 0.5 0.5 0.5\nKs 0.9 0.9 0.9\nNs 1000\nillum 3\n");
    EXPECT_EQ(mirror.model, MATERIAL_PHONG);
    EXPECT_EQ(mirror.specular, glm::vec3(0.5F));  // no more than is left
    EXPECT_EQ(mirror.exponent, 1000.0F);
    const SceneMaterial metal = material("Kd 1 1 1\nPr 0.25\nPm 1\n");
    EXPECT_EQ(metal.principled.metallic, 1.0F);
    EXPECT_EQ(metal.alpha, glm::vec2(0.25F));
    const SceneMaterial glass = material("Kd 0 0 0\nTf 0.9 1 1\nNi 1.33\nillum 7\n");
    EXPECT_EQ(glass.model, MATERIAL_DIELECTRIC);
    EXPECT_FLOAT_EQ(glass.eta.x, 1.33F);
    EXPECT_EQ(glass.transmitted, glm::vec3(0.9F, 1, 1));
    EXPECT_EQ(material("d 0.5\nillum 4\n").model, MATERIAL_DIELECTRIC);
    EXPECT_EQ(material("illum 4\n").model, MATERIAL_DIFFUSE);
}

TEST_F(Models, Opacity) {
    for (const char* statement : {"d 0.25\n", "Tr 0.75\n", "d -halo 0.25\n"}) {
        const Scene scene = of_material(statement);
        const SceneMaterial& m = scene.materials.at(scene.triangles.at(0).material);
        ASSERT_EQ(m.model, MATERIAL_BLEND);
        EXPECT_EQ(m.weight, 0.25F);
        EXPECT_EQ(scene.materials.at(static_cast<std::size_t>(m.blended[0])).model, MATERIAL_PASS);
    }
}

TEST_F(Models, Pictures) {
    write("a b.png", png(1, 1, 3, {255, 0, 0}));
    write("holes.png", png(1, 1, 4, {255, 255, 255, 0}));
    const Scene scene = of_material("map_Kd -s 2 3 1 -o 0.25 0.5 0 -clamp on a b.png\nmap_d holes.png\nmap_Bump -bm 0.5 a b.png\n");
    const SceneMaterial& mask = scene.materials.at(scene.triangles.at(0).material);
    ASSERT_EQ(mask.model, MATERIAL_BLEND);
    EXPECT_TRUE(mask.weight_is_opacity);
    const SceneMaterial& m = scene.materials.at(static_cast<std::size_t>(mask.blended[1]));
    EXPECT_EQ(m.albedo, glm::vec3(1));
    EXPECT_TRUE(m.bump);
    EXPECT_EQ(m.bump_scale, 0.5F);
    const Texture& t = scene.textures.at(static_cast<std::size_t>(m.albedo_texture));
    EXPECT_EQ(t.wrap_u, Texture::Wrap::clamp);
    // (0.5, 0.25) from the lower left is (0.5, 0.75) from the upper left; scaled and moved (1.25, 1.25), from the upper left (1.25, -0.25).
    expect_near(t.to_uv * glm::dvec3(0.5, 0.75, 1), {1.25, -0.25, 1}, 1e-12);
    EXPECT_EQ(scene.uvs[0], glm::vec2(0, 1));  // the lower left of the picture
    EXPECT_TRUE(has_warning(of_material("map_Kd nothing.png\n"), "goes without"));
    EXPECT_TRUE(has_warning(of_material("map_Kd ../a.png\n"), "goes without"));
}

TEST_F(Models, SmoothWithinGroupsAndElseFlat) {
    // Two faces at a right angle that share an edge.
    const std::string fold = "v 0 0 0\nv 0 1 0\nv 1 0 0\nv 0 0 1\n";
    const Scene flat = obj(fold + "s off\nf 1 3 2\nf 1 2 4\n");
    for (const glm::vec3& n : flat.normals) EXPECT_EQ(n, glm::vec3(0));
    const Scene smooth = obj(fold + "s 1\nf 1 3 2\nf 1 2 4\n");
    double most = 0;
    for (const glm::vec3& n : smooth.normals) most = std::max<double>(most, std::abs(n.x * n.z));
    EXPECT_NEAR(most, 0.5, 1e-6);  // half way between both
    const Scene two = obj(fold + "s 1\nf 1 3 2\ns 2\nf 1 2 4\n");
    for (const glm::vec3& n : two.normals) EXPECT_NEAR(std::max(std::abs(n.x), std::abs(n.z)), 1.0F, 1e-6);
}

TEST_F(Models, ColoursOfVertices) {
    const Scene scene = obj("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nf 1 2 3\n");
    ASSERT_EQ(scene.colours.size(), 3U);
    EXPECT_EQ(scene.colours[1], glm::vec3(0, 1, 0));
    EXPECT_NEAR(scene.colours[2].z, 0.21404F, 1e-5);
    EXPECT_EQ(scene.textures.at(static_cast<std::size_t>(scene.materials[0].albedo_texture)).kind, Texture::Kind::vertex_colours);
}

TEST_F(Models, Ply) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
        "property uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0 255 0 0\n1 0 0 0 255 0\n0 1 0 0 0 255\n3 0 1 2\n";
    const Scene scene = load_scene(write("m.ply", text));
    EXPECT_EQ(scene.shapes.at(0).kind, "ply");
    EXPECT_EQ(scene.colours.at(2), glm::vec3(0, 0, 1));
    EXPECT_TRUE(scene.environment);
    EXPECT_NE(
        message_of("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n",
                   "m.ply")
            .find("no faces"),
        std::string::npos);
}

TEST_F(Models, DefectsOfLibrariesNameTheirLine) {
    write("m.mtl", "newmtl a\nKd 1 x 1\n");
    const Scene scene = obj("mtllib m.mtl\n" + std::string(square) + "usemtl a\nf 1 2 3\n");
    EXPECT_TRUE(has_warning(scene, "m.mtl:2: \"x\" is not a number"));
}

TEST_F(Models, OneBadLineOfALibraryCostsNoMoreThanItself) {
    const Scene scene = of_material("Ns nan\nNi\nKd 1 0 0\n");
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(1, 0, 0));
    EXPECT_TRUE(has_warning(scene, "m.mtl:2: \"nan\" is not a finite number; the line is left out"));
    EXPECT_TRUE(has_warning(scene, "m.mtl:3: "));
}

/// A lamp lights a room; the display of a device does not.
TEST_F(Models, OnlyPicturesThatGlowGetASky) {
    write("white.ppm", "P3 1 1 255 255 255 255\n");
    EXPECT_FALSE(of_material("Ke 1 1 1\n").environment);
    EXPECT_TRUE(of_material("Ke 1 1 1\nmap_Ke white.ppm\n").environment);
    EXPECT_TRUE(has_warning(of_material("Ke 1 1 1\nmap_Ke white.ppm\n"), "only pictures on surfaces glow"));
    EXPECT_FALSE(of_material("Ke 5 5 5\nmap_Ke white.ppm\n").environment);
}

}  // namespace
}  // namespace pencil::test
