// Materials of an OBJ in a Mitsuba scene: those of its own library, and those that the scene gives by the names of the mesh.
#include "unit/gltf_fixture.h"

namespace pencil::test {
namespace {

class MitsubaMtl : public GltfTest {
protected:
    void SetUp() override {
        GltfTest::SetUp();
        write("meshes/m.obj",
              "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
              "usemtl redWall\nf 1/1 2/2 3/3\nusemtl Lamp shade\nf 1/1 3/3 4/4\n");
        write("meshes/m.mtl",
              "newmtl redWall\nKd 1 0.5 0\n\nnewmtl Lamp shade\nKd 0.2 0.2 0.2\nKs 0.3 0.3 0.3\nNs 50\nillum 2\nKe 9 9 9\n");
    }
    /// In a file of this version.
    Scene shape(const std::string& inside, const std::string& version = "0.6.0") const {
        return load_text("<scene version=\"" + version +
                         "\">\n<sensor type=\"perspective\"/>\n"
                         "<shape type=\"obj\"><string name=\"filename\" value=\"meshes/m.obj\"/>\n" +
                         inside + "</shape></scene>");
    }
    static const SceneMaterial& material(const Scene& scene, std::size_t triangle) {
        return scene.materials.at(scene.triangles.at(triangle).material);
    }
    static std::string plastic(const std::string& name) { return "<bsdf type=\"plastic\" name=\"" + name + "\"/>"; }
};

TEST_F(MitsubaMtl, TheLibraryOfTheMeshIsRead) {
    const Scene scene = shape("");
    ASSERT_EQ(scene.shapes.size(), 2U);
    EXPECT_EQ(scene.shapes[0].id, "obj 1 redWall");
    EXPECT_EQ(material(scene, 0).model, MATERIAL_DIFFUSE);
    EXPECT_EQ(material(scene, 0).id, "redWall");
    EXPECT_NEAR(material(scene, 0).albedo.y, 0.2140F, 1e-4) << "a value of a screen";
    EXPECT_FALSE(material(scene, 0).two_sided);
    EXPECT_EQ(material(scene, 1).model, MATERIAL_PHONG);
    EXPECT_EQ(material(scene, 1).exponent, 50.0F);
    EXPECT_FALSE(scene.shapes[1].emits) << "Ke is not read there";
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
}

TEST_F(MitsubaMtl, TheScenesMaterialsTakePrecedence) {
    EXPECT_EQ(shape("<bsdf type=\"plastic\"/>").shapes.size(), 1U);
    EXPECT_EQ(material(shape("<bsdf type=\"plastic\"/>"), 1).model, MATERIAL_PLASTIC);
    const Scene one = shape(plastic("redWall"));
    EXPECT_EQ(material(one, 0).model, MATERIAL_PLASTIC);
    EXPECT_EQ(material(one, 1).model, MATERIAL_PHONG) << "that of the library";
    const Scene two = shape("<bsdf type=\"dielectric\"/>" + plastic("Lamp shade"));
    EXPECT_EQ(material(two, 0).model, MATERIAL_DIELECTRIC);
    EXPECT_EQ(material(two, 1).model, MATERIAL_PLASTIC);
    EXPECT_EQ(material(shape(plastic("Lamp shade") + "<bsdf type=\"dielectric\"/>"), 1).model, MATERIAL_DIELECTRIC) << "the last counts";
    const Scene by_reference = load_text(
        "<scene version=\"0.5.0\"><sensor type=\"perspective\"/><bsdf type=\"plastic\" id=\"p\"/><shape type=\"obj\"><string "
        "name=\"filename\" value=\"meshes/m.obj\"/><ref name=\"redWall\" id=\"p\"/></shape></scene>");
    EXPECT_EQ(material(by_reference, 0).model, MATERIAL_PLASTIC);
}

TEST_F(MitsubaMtl, NamesThatTheMeshLacks) {
    const Scene scene = shape(plastic("redWal") + plastic("Lamp shade"));
    EXPECT_TRUE(has_warning(scene, "the mesh has no material \"redWal\": ignored; did you mean \"redWall\"?"));
    EXPECT_EQ(material(scene, 0).model, MATERIAL_DIFFUSE);
    const Scene alone = shape(plastic("bsdf"));
    EXPECT_EQ(alone.shapes.size(), 1U);
    EXPECT_EQ(material(alone, 0).model, MATERIAL_PLASTIC) << "a name that says nothing";
}

TEST_F(MitsubaMtl, WithoutALibrary) {
    const Scene off = shape("<boolean name=\"loadMaterials\" value=\"false\"/>");
    EXPECT_EQ(off.shapes.size(), 1U) << "one grey";
    EXPECT_EQ(material(off, 0).albedo, glm::vec3(0.5F));
    EXPECT_TRUE(has_warning(off, "nothing says what material \"redWall\" is"));
    std::filesystem::remove(folder_ / "meshes/m.mtl");
    const Scene lost = shape("");
    EXPECT_TRUE(has_warning(lost, "does not exist; its materials are left out"));
    EXPECT_EQ(material(lost, 1).albedo, glm::vec3(0.5F));
}

TEST_F(MitsubaMtl, LaterVersionsPassMaterialsOver) {
    const Scene scene = shape("", "3.0.0");
    EXPECT_EQ(scene.shapes.size(), 1U);
    EXPECT_EQ(material(scene, 0).albedo, glm::vec3(0.5F));
    EXPECT_TRUE(has_warning(shape(plastic("a") + plastic("b"), "3.0.0"), "the first is used"));
}

TEST_F(MitsubaMtl, PicturesGlassAndOpacity) {
    write("meshes/a.png", png(1, 1, 3, {255, 0, 0}));
    write("meshes/m.mtl", "newmtl redWall\nmap_Kd a.png\nbump a.png\nd 0.25\nnewmtl Lamp shade\nillum 4\n");
    const Scene scene = shape("");
    const SceneMaterial& mask = material(scene, 0);
    ASSERT_EQ(mask.model, MATERIAL_BLEND);
    EXPECT_EQ(mask.weight, 0.25F);
    const SceneMaterial& covered = scene.materials.at(static_cast<std::size_t>(mask.blended[1]));
    EXPECT_NE(covered.albedo_texture, no_texture);
    EXPECT_TRUE(covered.bump);
    EXPECT_EQ(material(scene, 1).model, MATERIAL_DIELECTRIC);
    write("meshes/m.mtl", "newmtl redWall\nmap_Kd b.png\n");
    EXPECT_TRUE(has_warning(shape(""), "m.mtl: texture type \"bitmap\": picture \"b.png\" is not there"));
    write("meshes/m.mtl", "newmtl redWall\nmap_Kd ../../../etc/passwd\nKd x\n");
    EXPECT_TRUE(has_warning(shape(""), "\"x\" is not a number; the line is left out"));
    EXPECT_TRUE(has_warning(shape(""), "leads outside the scene's folder"));
}

TEST_F(MitsubaMtl, AllPartsOfALampShine) {
    const Scene scene = shape("<emitter type=\"area\"><rgb name=\"radiance\" value=\"1\"/></emitter>");
    ASSERT_EQ(scene.shapes.size(), 2U);
    EXPECT_TRUE(scene.shapes[0].emits && scene.shapes[1].emits);
}

TEST_F(MitsubaMtl, DamagedLibrariesNeverCrash) {
    const std::string text = "newmtl redWall\nKd 1 0.5 0\nmap_Kd -s 1 2 a.png\nillum 2\nNs 3\nKs 1 1 1\nd 0.5\nbump x\n";
    for (std::size_t n = 0; n < text.size(); ++n) {
        for (const std::string& damaged : {text.substr(0, n), text.substr(0, n) + "\"<&\xff" + text.substr(n)}) {
            write("meshes/m.mtl", damaged);
            try {
                shape("");
            } catch (const SceneError&) {
            }
        }
    }
}

}  // namespace
}  // namespace pencil::test
