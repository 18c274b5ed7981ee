// Mitsuba's materials, plugin by plugin, as fields of SceneMaterial.
#include "scene/scene_fingerprint.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

class MitsubaMaterials : public SceneTest {
protected:
    /// Material of a shape with this <bsdf>.
    SceneMaterial material(const std::string& bsdf, const std::string& version = "3.0.0") {
        scene_ = load_text("<scene version=\"" + version + "\"><sensor type=\"perspective\"/>\n<shape type=\"cube\">" + bsdf +
                           "</shape></scene>");
        return scene_.materials[scene_.triangles[0].material];
    }
    const SceneMaterial& blended(const SceneMaterial& blend, std::size_t i) const {
        return scene_.materials[static_cast<std::size_t>(blend.blended[i])];
    }

    Scene scene_;
};

TEST_F(MitsubaMaterials, Diffuse) {
    EXPECT_EQ(material("<bsdf type=\"diffuse\"/>").albedo, glm::vec3(0.5F));
    EXPECT_EQ(material("<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.1 0.2 0.3\"/></bsdf>").albedo,
              glm::vec3(0.1F, 0.2F, 0.3F));
    const SceneMaterial rough = material("<bsdf type=\"roughdiffuse\"><float name=\"alpha\" value=\"0.2\"/></bsdf>");
    EXPECT_EQ(rough.model, MATERIAL_ROUGH_DIFFUSE);
    EXPECT_NEAR(rough.alpha.x, 0.2 / std::sqrt(2.0), 1e-6);
}

TEST_F(MitsubaMaterials, Conductors) {
    SceneMaterial m = material("<bsdf type=\"conductor\"/>");
    EXPECT_EQ(m.model, MATERIAL_CONDUCTOR);
    EXPECT_TRUE(m.perfect_mirror);
    EXPECT_EQ(m.alpha, glm::vec2(0.0F));
    m = material("<bsdf type=\"conductor\"/>", "0.5.0");  // copper was what nothing meant
    EXPECT_FALSE(m.perfect_mirror);
    EXPECT_NEAR(m.k.x, 3.91326, 1e-4);
    m = material(
        "<bsdf type=\"roughconductor\"><string name=\"material\" value=\"Au\"/><float name=\"alpha\" value=\"0.3\"/>"
        "<string name=\"distribution\" value=\"ggx\"/><rgb name=\"specular_reflectance\" value=\"0.9\"/></bsdf>");
    EXPECT_EQ(m.alpha, glm::vec2(0.3F));
    EXPECT_FALSE(m.beckmann);
    EXPECT_EQ(m.specular, glm::vec3(0.9F));
    EXPECT_NEAR(m.eta.z, 1.44205, 1e-4);
    m = material(
        "<bsdf type=\"roughconductor\"><rgb name=\"eta\" value=\"1 2 3\"/><rgb name=\"k\" value=\"4 5 6\"/>"
        "<float name=\"alpha_u\" value=\"0.1\"/><float name=\"alpha_v\" value=\"0.2\"/></bsdf>");
    EXPECT_EQ(m.eta, glm::vec3(1, 2, 3));
    EXPECT_EQ(m.k, glm::vec3(4, 5, 6));
    EXPECT_EQ(m.alpha, glm::vec2(0.1F, 0.2F));
    EXPECT_TRUE(m.beckmann);
    m = material("<bsdf type=\"conductor\"><string name=\"material\" value=\"Ag\"/><string name=\"extEta\" value=\"water\"/></bsdf>",
                 "0.6.0");
    EXPECT_NEAR(m.k.x, 4.82835 / 1.333, 1e-4);
    expect_approximation("<bsdf type=\"conductor\"><string name=\"material\" value=\"Agg\"/></bsdf>", 3, "did you mean \"Ag\"?");
    expect_approximation("<bsdf type=\"roughconductor\"><string name=\"distribution\" value=\"phong\"/></bsdf>", 3, "read as \"beckmann\"");
}

TEST_F(MitsubaMaterials, Dielectrics) {
    SceneMaterial m = material("<bsdf type=\"dielectric\"/>");
    EXPECT_EQ(m.model, MATERIAL_DIELECTRIC);
    EXPECT_NEAR(m.eta.x, 1.50418, 1e-4);  // bk7 over air, as Mitsuba prints it
    m = material(
        "<bsdf type=\"thindielectric\"><string name=\"int_ior\" value=\"diamond\"/><float name=\"ext_ior\" value=\"1\"/>"
        "<rgb name=\"specular_transmittance\" value=\"0.5\"/></bsdf>");
    EXPECT_TRUE(m.thin);
    EXPECT_NEAR(m.eta.x, 2.419, 1e-5);
    EXPECT_EQ(m.transmitted, glm::vec3(0.5F));
    m = material(
        "<bsdf type=\"roughdielectric\"><string name=\"int_ior\" value=\"1.7\"/><string name=\"ext_ior\" value=\"vacuum\"/></bsdf>");
    EXPECT_NEAR(m.eta.x, 1.7, 1e-5);
    EXPECT_EQ(m.alpha, glm::vec2(0.1F));
}

TEST_F(MitsubaMaterials, PlasticsAndPhong) {
    SceneMaterial m = material("<bsdf type=\"plastic\"/>");
    EXPECT_EQ(m.model, MATERIAL_PLASTIC);
    EXPECT_NEAR(m.eta.x, 1.48959, 1e-4);
    EXPECT_EQ(m.alpha, glm::vec2(0.0F));
    m = material(
        "<bsdf type=\"roughplastic\"><boolean name=\"nonlinear\" value=\"true\"/><rgb name=\"diffuse_reflectance\" value=\"0.2\"/></bsdf>");
    EXPECT_EQ(m.alpha, glm::vec2(0.1F));
    EXPECT_TRUE(m.nonlinear);
    EXPECT_EQ(m.albedo, glm::vec3(0.2F));
    m = material("<bsdf type=\"phong\"><float name=\"exponent\" value=\"50\"/></bsdf>", "0.6.0");
    EXPECT_EQ(m.model, MATERIAL_PHONG);
    EXPECT_EQ(m.exponent, 50.0F);
    EXPECT_EQ(m.specular, glm::vec3(0.2F));
    expect_approximation("<bsdf type=\"ward\"/>", 3, "read as phong");
}

TEST_F(MitsubaMaterials, Principled) {
    SceneMaterial m = material(
        "<bsdf type=\"principled\"><rgb name=\"base_color\" value=\"0.1 0.2 0.3\"/><float name=\"roughness\" value=\"0.4\"/>"
        "<float name=\"metallic\" value=\"0.7\"/><float name=\"specular\" value=\"0.5\"/><float name=\"clearcoat\" value=\"1\"/></bsdf>");
    EXPECT_EQ(m.model, MATERIAL_PRINCIPLED);
    EXPECT_EQ(m.albedo, glm::vec3(0.1F, 0.2F, 0.3F));
    EXPECT_EQ(m.alpha, glm::vec2(0.4F));
    EXPECT_EQ(m.principled.metallic, 0.7F);
    EXPECT_EQ(m.principled.clearcoat, 1.0F);
    EXPECT_NEAR(m.eta.x, 1.5, 1e-6);  // reflects 4 % at normal incidence
    EXPECT_NEAR(material("<bsdf type=\"principled\"><float name=\"eta\" value=\"1.33\"/></bsdf>").eta.x, 1.33, 1e-6);
    expect_approximation("<bsdf type=\"principledthin\"/>", 3, "opaque and two-sided");
}

TEST_F(MitsubaMaterials, TwoSided) {
    EXPECT_TRUE(material("<bsdf type=\"twosided\"><bsdf type=\"plastic\"/></bsdf>").two_sided);
    SceneMaterial m = material("<bsdf type=\"twosided\"><bsdf type=\"plastic\"/><bsdf type=\"diffuse\" id=\"back\"/></bsdf>");
    EXPECT_TRUE(m.two_sided);
    EXPECT_EQ(scene_.materials[static_cast<std::size_t>(m.back)].id, "back");
    m = material(
        "<bsdf type=\"twosided\"><bsdf type=\"blendbsdf\"><float name=\"weight\" value=\"0.2\"/><bsdf type=\"diffuse\"/><bsdf "
        "type=\"plastic\"/></bsdf></bsdf>");
    EXPECT_EQ(m.model, MATERIAL_BLEND);
    EXPECT_TRUE(blended(m, 0).two_sided && blended(m, 1).two_sided);
    EXPECT_FALSE(material("<bsdf type=\"twosided\"><bsdf type=\"dielectric\"/></bsdf>").two_sided);
}

TEST_F(MitsubaMaterials, MasksAndBlends) {
    SceneMaterial m = material("<bsdf type=\"mask\"><float name=\"opacity\" value=\"0.3\"/><bsdf type=\"diffuse\" id=\"leaf\"/></bsdf>");
    EXPECT_EQ(m.model, MATERIAL_BLEND);
    EXPECT_EQ(m.weight, 0.3F);
    EXPECT_EQ(blended(m, 0).model, MATERIAL_PASS);
    EXPECT_EQ(blended(m, 1).id, "leaf");
    m = material(
        "<bsdf type=\"mixturebsdf\"><string name=\"weights\" value=\"0.2, 0.3, 0.5\"/><bsdf type=\"diffuse\"/><bsdf type=\"plastic\"/>"
        "<bsdf type=\"conductor\"/></bsdf>",
        "0.5.0");
    EXPECT_EQ(m.weight, 0.5F);
    EXPECT_EQ(blended(m, 1).model, MATERIAL_CONDUCTOR);
    EXPECT_NEAR(blended(m, 0).weight, 0.6, 1e-6);
    EXPECT_EQ(blended(blended(m, 0), 0).model, MATERIAL_DIFFUSE);
    for (std::size_t i = 0; i < scene_.materials.size(); ++i)
        for (const std::int64_t index : scene_.materials[i].blended) EXPECT_LT(index, static_cast<std::int64_t>(i));
    EXPECT_EQ(material("<bsdf type=\"null\"/>").model, MATERIAL_PASS);
}

TEST_F(MitsubaMaterials, ReliefOfWhatScatters) {
    const std::string map = "<texture type=\"checkerboard\"/>";
    SceneMaterial m = material("<bsdf type=\"bumpmap\">" + map + "<float name=\"scale\" value=\"3\"/><bsdf type=\"plastic\"/></bsdf>");
    EXPECT_EQ(m.model, MATERIAL_PLASTIC);
    EXPECT_TRUE(m.bump);
    EXPECT_EQ(m.bump_scale, 3.0F);
    ASSERT_GE(m.normal_texture, 0);
    m = material("<bsdf type=\"normalmap\"><texture name=\"normalmap\" type=\"checkerboard\"/><bsdf type=\"plastic\"/></bsdf>");
    EXPECT_FALSE(m.bump);
    EXPECT_FALSE(m.y_against_v);
    EXPECT_GE(m.normal_texture, 0);
    m = material("<bsdf type=\"bump\">" + map + "<bsdf type=\"mask\"><bsdf type=\"diffuse\"/></bsdf></bsdf>");
    EXPECT_EQ(m.normal_texture, no_texture);
    EXPECT_GE(blended(m, 1).normal_texture, 0);
}

TEST_F(MitsubaMaterials, NullOnALightIsBlack) {
    const Scene scene = load_body("<shape type=\"rectangle\"><bsdf type=\"null\"/><emitter type=\"area\"/></shape>");
    EXPECT_EQ(scene.materials[scene.triangles[0].material].model, MATERIAL_DIFFUSE);
    EXPECT_EQ(scene.materials[scene.triangles[0].material].albedo, glm::vec3(0.0F));
    EXPECT_TRUE(has_warning(scene, "null material on a light"));
}

TEST_F(MitsubaMaterials, BoundariesOfMediaWithoutAMaterial) {
    scene_ = load_text(
        "<scene version=\"0.5.0\"><sensor type=\"perspective\"/><shape type=\"cube\"><medium name=\"interior\" "
        "type=\"homogeneous\"/></shape></scene>");
    EXPECT_EQ(scene_.materials[scene_.triangles[0].material].model, MATERIAL_PASS);
    EXPECT_TRUE(has_warning(scene_, "has a medium, which is not supported: left out"));
}

TEST_F(MitsubaMaterials, CirclesAndTowersOfReferencesEnd) {
    EXPECT_NE(error_of_body("<bsdf type=\"mask\" id=\"a\"><ref id=\"a\"/></bsdf>").find("refers to itself"), std::string::npos);
    EXPECT_NE(
        error_of_body("<bsdf type=\"twosided\" id=\"a\"><ref id=\"b\"/></bsdf><bsdf type=\"twosided\" id=\"b\"><ref id=\"a\"/></bsdf>")
            .find("refers to itself"),
        std::string::npos);
    std::string tower = "<bsdf type=\"diffuse\" id=\"b0\"/>";
    for (int i = 1; i < 100; ++i) {
        const std::string below = "<ref id=\"b" + std::to_string(i - 1) + "\"/>";
        tower +=
            "<bsdf type=\"blendbsdf\" id=\"b" + std::to_string(i) + "\"><float name=\"weight\" value=\"0.5\"/>" + below + below + "</bsdf>";
    }
    EXPECT_NE(error_of_body(tower + "<bsdf type=\"twosided\"><ref id=\"b99\"/></bsdf>"), "");
}

/// What exporters of two generations write for the same scene.
TEST_F(MitsubaMaterials, OldAndNewSpellingsGiveTheSameScene) {
    const char* const old_text = R"(<scene version="0.5.0"><sensor type="perspective"><float name="fov" value="40"/>
        <transform name="toWorld"><lookat origin="0,0,-5" target="0,0,0" up="0,1,0"/></transform></sensor>
        <bsdf type="roughplastic" id="a"><string name="intIOR" value="bk7"/><rgb name="diffuseReflectance" value="0.1 0.2 0.3"/><float name="alpha" value="0.2"/></bsdf>
        <bsdf type="roughconductor" id="b"><string name="material" value="Al"/><float name="alphaU" value="0.1"/><float name="alphaV" value="0.3"/>
            <rgb name="specularReflectance" value="0.8"/></bsdf>
        <bsdf type="dielectric" id="c"><float name="extIOR" value="1.2"/><rgb name="specularTransmittance" value="0.7"/></bsdf>
        <shape type="cube"><ref id="a"/><transform name="toWorld"><translate x="1"/></transform></shape>
        <shape type="rectangle"><ref id="b"/><boolean name="flipNormals" value="true"/></shape><shape type="disk"><ref id="c"/></shape>
        <emitter type="spot"><float name="cutoffAngle" value="30"/><float name="beamWidth" value="10"/></emitter></scene>)";
    const char* const new_text = R"(<scene version="3.0.0"><sensor type="perspective"><float name="fov" value="40"/>
        <transform name="to_world"><lookat origin="0,0,-5" target="0,0,0" up="0,1,0"/></transform></sensor>
        <bsdf type="roughplastic" id="a"><string name="int_ior" value="bk7"/><rgb name="diffuse_reflectance" value="0.1 0.2 0.3"/><float name="alpha" value="0.2"/></bsdf>
        <bsdf type="roughconductor" id="b"><string name="material" value="Al"/><float name="alpha_u" value="0.1"/><float name="alpha_v" value="0.3"/>
            <rgb name="specular_reflectance" value="0.8"/></bsdf>
        <bsdf type="dielectric" id="c"><float name="ext_ior" value="1.2"/><rgb name="specular_transmittance" value="0.7"/></bsdf>
        <shape type="cube"><ref id="a"/><transform name="to_world"><translate x="1"/></transform></shape>
        <shape type="rectangle"><ref id="b"/><boolean name="flip_normals" value="true"/></shape><shape type="disk"><ref id="c"/></shape>
        <emitter type="spot"><float name="cutoff_angle" value="30"/><float name="beam_width" value="10"/></emitter></scene>)";
    const Scene before = load_text(old_text), after = load_text(new_text);
    EXPECT_EQ(before.warnings, std::vector<std::string>());
    EXPECT_EQ(after.warnings, std::vector<std::string>());
    EXPECT_EQ(scene_fingerprint(before), scene_fingerprint(after));
}

/// As Mitsuba 0.x scales them.
TEST_F(MitsubaMaterials, PhongReflectsNoMoreThanAll) {
    const std::string bright =
        "<bsdf type=\"phong\"><rgb name=\"diffuse_reflectance\" value=\"0.9 0.1 0.1\"/><rgb "
        "name=\"specular_reflectance\" value=\"0.6\"/>";
    const SceneMaterial m = material(bright + "</bsdf>", "0.6.0");
    EXPECT_NEAR(m.albedo.x + m.specular.x, 0.99F, 1e-5);
    EXPECT_NEAR(m.albedo.x / m.albedo.y, 9.0F, 1e-4);
    EXPECT_EQ(material(bright + "<boolean name=\"ensureEnergyConservation\" value=\"false\"/></bsdf>", "0.6.0").albedo.x, 0.9F);
    EXPECT_EQ(material("<bsdf type=\"phong\"/>", "0.6.0").albedo.x, 0.5F);
}

}  // namespace
}  // namespace pencil::test
