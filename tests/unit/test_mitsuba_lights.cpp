// Mitsuba's emitters, sensors and films, and the integrators that are read as "path".
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "scene/mitsuba/sun_position.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

class MitsubaLights : public SceneTest {
protected:
    Scene with_sensor(const std::string& sensor) const { return load_text("<scene version=\"3.0.0\">\n" + sensor + "</scene>"); }
};

TEST_F(MitsubaLights, Spot) {
    const Scene scene = load_body(
        "<emitter type=\"spot\"><rgb name=\"intensity\" value=\"2\"/><float name=\"cutoff_angle\" value=\"40\"/>"
        "<transform name=\"to_world\"><lookat origin=\"0,5,0\" target=\"0,0,0\" up=\"0,0,1\"/></transform></emitter>");
    ASSERT_EQ(scene.point_lights.size(), 1U);
    const PointLight& light = scene.point_lights[0];
    EXPECT_TRUE(light.is_spot);
    EXPECT_EQ(light.cutoff, 40);
    EXPECT_EQ(light.beam_width, 30);  // three quarters
    EXPECT_EQ(light.intensity, glm::vec3(2.0F));
    expect_near(light.position, {0, 5, 0}, 1e-12);
    expect_near(light.to_world * glm::dvec3(0, 0, 1), {0, -1, 0}, 1e-12);
    expect_error("<emitter type=\"spot\">\n<float name=\"cutoff_angle\" value=\"0\"/></emitter>", 4, "cutoff_angle");
}

TEST_F(MitsubaLights, Directional) {
    const Scene scene = load_body(
        "<emitter type=\"directional\"><vector name=\"direction\" x=\"0\" y=\"-2\" z=\"0\"/><rgb name=\"irradiance\" "
        "value=\"3\"/></emitter>"
        "<emitter type=\"directional\"><transform name=\"to_world\"><rotate y=\"1\" angle=\"90\"/></transform></emitter>");
    ASSERT_EQ(scene.directional_lights.size(), 2U);
    expect_near(scene.directional_lights[0].direction, {0, -1, 0}, 1e-12);
    EXPECT_EQ(scene.directional_lights[0].irradiance, glm::vec3(3.0F));
    expect_near(scene.directional_lights[1].direction, {1, 0, 0}, 1e-12);
}

TEST_F(MitsubaLights, Environments) {
    EXPECT_EQ(load_body("<emitter type=\"constant\"><rgb name=\"radiance\" value=\"0.5\"/></emitter>").environment->radiance,
              glm::vec3(0.5F));
    write("sky.ppm", "P3 2 1 255\n255 0 0\n0 188 0\n");
    const Scene scene = load_body(
        "<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.ppm\"/><float name=\"scale\" value=\"2\"/>"
        "<transform name=\"to_world\"><rotate x=\"1\" angle=\"90\"/></transform></emitter><emitter type=\"constant\"/>");
    ASSERT_TRUE(scene.environment && scene.environment->is_map());
    EXPECT_EQ(scene.environment->width, 2);
    EXPECT_EQ(scene.environment->radiance, glm::vec3(2.0F));
    EXPECT_NEAR(scene.environment->texels[1].y, 0.5029, 1e-3);
    expect_near(scene.environment->to_world * glm::dvec3(0, 1, 0), {0, 0, 1}, 1e-12);
    EXPECT_TRUE(has_warning(scene, "second light from all around: left out"));
    expect_error("<emitter type=\"envmap\"/>", 3, "needs a filename");
}

/// Against Mitsuba 3.9.1 (scalar_rgb), which integrates conductors' spectra as those of reflectances.
TEST_F(MitsubaLights, SpectraAsPlugins) {
    const auto radiance = [&](const std::string& spectrum) {
        return load_body("<emitter type=\"constant\"><spectrum name=\"radiance\" " + spectrum + "</emitter>").environment->radiance;
    };
    EXPECT_EQ(radiance("type=\"d65\"><float name=\"scale\" value=\"2\"/></spectrum>"), glm::vec3(2.0F));
    EXPECT_EQ(radiance("type=\"uniform\"><float name=\"value\" value=\"3\"/></spectrum>"), glm::vec3(3.0F));
    expect_near(
        radiance("type=\"irregular\"><string name=\"wavelengths\" value=\"360, 830\"/><string name=\"values\" value=\"1, 1\"/></spectrum>"),
        radiance("value=\"1\"/>"), 1e-4);
    const glm::vec3 hot = radiance("type=\"blackbody\"><float name=\"temperature\" value=\"5000\"/></spectrum>");
    EXPECT_NEAR(hot.y, 1.21e4, 100);
    EXPECT_TRUE(hot.x > hot.y && hot.y > hot.z);
    write("a.spd", "# nm value\n360 1\n830 1\n");
    const Scene scene = load_body(
        "<shape type=\"cube\"><bsdf type=\"conductor\"><spectrum name=\"eta\" filename=\"a.spd\"/><spectrum name=\"k\" "
        "value=\"2\"/></bsdf></shape>");
    expect_near(scene.materials[0].eta, glm::dvec3(1), 1e-3);
    EXPECT_EQ(scene.materials[0].k, glm::vec3(2.0F));
}

TEST_F(MitsubaLights, AreaByReference) {
    const Scene scene = load_body(
        "<emitter type=\"area\" id=\"lamp\"><rgb name=\"radiance\" value=\"7\"/></emitter>\n"
        "<shape type=\"rectangle\"><ref id=\"lamp\"/></shape>");
    EXPECT_TRUE(scene.shapes[0].emits);
    EXPECT_EQ(scene.shapes[0].radiance, glm::vec3(7.0F));
    EXPECT_EQ(scene.warnings, std::vector<std::string>());
}

/// The sun's place as the almanac has it, and the zenith by version.
TEST_F(MitsubaLights, Daylight) {
    PlaceAndTime noon;  // Greenwich at an equinox
    noon.latitude = 51.48;
    noon.longitude = noon.timezone = 0;
    noon.year = 2020;
    noon.month = 3;
    noon.day = 20;
    noon.hour = 12.1239;  // the equation of time is -7.4 minutes
    EXPECT_NEAR(sun_position(noon).elevation * 57.29578, 90 - 51.48, 0.2);
    EXPECT_NEAR(std::abs(sun_position(noon).azimuth) * 57.29578, 180, 0.2);
    Scene scene = load_body("<emitter type=\"sunsky\"><vector name=\"sun_direction\" x=\"0\" y=\"1\" z=\"1\"/></emitter>");
    ASSERT_EQ(scene.directional_lights.size(), 1U);
    expect_near(scene.directional_lights[0].direction, glm::normalize(glm::dvec3(0, -1, -1)), 1e-9);
    ASSERT_TRUE(scene.environment);
    expect_near(scene.environment->to_world * glm::dvec3(0, 1, 0), {0, 0, 1}, 1e-12);
    EXPECT_TRUE(has_warning(scene, "approximated"));
    scene = load_text(
        "<scene version=\"0.5.0\"><sensor type=\"perspective\"/><emitter type=\"sun\"><vector name=\"sunDirection\" "
        "y=\"1\"/></emitter></scene>");
    EXPECT_FALSE(scene.environment);
    const glm::vec3 sun = scene.directional_lights[0].irradiance;
    expect_near(scene.directional_lights[0].direction, {0, -1, 0}, 1e-9);
    EXPECT_TRUE(sun.x > sun.y && sun.y > sun.z && sun.x < 2) << sun.x;
    EXPECT_NE(error_of_body("<emitter type=\"sky\"><vector name=\"sun_direction\" x=\"0\"/></emitter>"), "");
}

TEST_F(MitsubaLights, PhotometricFile) {
    write("lamp.ies", "IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n1 1000 2 3 2 1 1 0.1 0.1 0\n1 1 100\n0 45 90\n0 90\n100 50 0\n200 50 0\n");
    const Scene scene = load_body("<emitter type=\"ies\"><string name=\"filename\" value=\"lamp.ies\"/></emitter>");
    ASSERT_EQ(scene.profiles.size(), 1U);
    const LightProfile& profile = scene.profiles[0];
    EXPECT_EQ(profile.vertical, (std::vector<float>{0, 45, 90}));
    EXPECT_EQ(profile.horizontal, (std::vector<float>{0, 90, 180, 270, 360}));  // by symmetry
    EXPECT_EQ(profile.values, (std::vector<float>{0.5F, 0.25F, 0, 1, 0.25F, 0, 0.5F, 0.25F, 0, 1, 0.25F, 0, 0.5F, 0.25F, 0}));
    EXPECT_NEAR(scene.point_lights[0].intensity.x, 400.0 / 683, 1e-6);
    for (const char* bad : {"", "TILT=NONE\n", "TILT=NONE\n1 1 1 4096 4096 1 1 0 0 0 1 1 1\n0 1", "TILT=NONE\n1 1 1 1e9 1 1 1 0 0 0 1 1 1",
                            "TILT=NONE\n1 1 1 2 1 1 1 0 0 0 1 1 1\n0 0 0 1 1", "TILT=NONE\n1 1 1 1 1 2 1 0 0 0 1 1 1\n0 0 1",
                            "TILT=NONE\n1 1 1 1 1 1 1 0 0 0 1 1 1\n0 0 -1"}) {
        write("bad.ies", bad);
        EXPECT_NE(error_of_body("<emitter type=\"ies\"><string name=\"filename\" value=\"bad.ies\"/></emitter>"), "") << bad;
    }
}

TEST_F(MitsubaLights, Sensors) {
    Scene scene = with_sensor(
        "<sensor type=\"thinlens\"><float name=\"aperture_radius\" value=\"0.1\"/><float name=\"focus_distance\" value=\"3\"/></sensor>");
    EXPECT_EQ(scene.sensor.aperture_radius, 0.1);
    EXPECT_EQ(scene.sensor.focus_distance, 3);
    scene = with_sensor(
        "<sensor type=\"orthographic\"><transform name=\"to_world\"><scale x=\"2\" y=\"2\"/><translate z=\"1\"/></transform></sensor>");
    EXPECT_TRUE(scene.sensor.orthographic);
    expect_near(glm::dvec3(scene.sensor.to_world * glm::dvec4(1, 0, 0, 1)), {2, 0, 1}, 1e-12);  // its scale is its width
    scene = with_sensor("<sensor type=\"radiancemeter\"/>\n<sensor type=\"perspective\"><float name=\"fov\" value=\"33\"/></sensor>");
    EXPECT_EQ(scene.sensor.fov_x, 33);
}

TEST_F(MitsubaLights, ScenesWithoutASensorAreSeenFromBefore) {
    const Scene scene = load_text("<scene version=\"3.0.0\"><shape type=\"cube\"/></scene>");
    EXPECT_TRUE(has_warning(scene, "scene.xml:1: the scene has no sensor"));
    const glm::dvec4 corner = glm::inverse(scene.sensor.to_world) * glm::dvec4(1, 1, -1, 1);
    EXPECT_NEAR(std::abs(corner.x) / corner.z, std::tan(22.5 * 3.14159265358979 / 180), 1e-9);  // at the edge of the film
}

TEST_F(MitsubaLights, CropWindows) {
    const auto film = [](const std::string& inside) {
        return "<sensor type=\"perspective\">\n<film type=\"mfilm\"><integer name=\"width\" value=\"100\"/><integer name=\"height\" "
               "value=\"50\"/>" +
               inside + "</film></sensor>";
    };
    const auto number = [](const std::string& name, int value) {
        return "<integer name=\"" + name + "\" value=\"" + std::to_string(value) + "\"/>";
    };
    EXPECT_EQ(with_sensor(film("")).sensor.crop_width, 0);
    const PerspectiveSensor sensor =
        with_sensor(film(number("crop_offset_x", 10) + number("cropOffsetY", 20) + number("crop_width", 30) + number("crop_height", 5)))
            .sensor;
    EXPECT_EQ(glm::ivec4(sensor.crop_x, sensor.crop_y, sensor.crop_width, sensor.crop_height), glm::ivec4(10, 20, 30, 5));
    EXPECT_EQ(with_sensor(film(number("crop_offset_x", 10))).sensor.crop_width, 90);
    expect_error(film(number("crop_width", 101)), 4, "leaves the film");
    expect_error(film(number("crop_offset_y", 50)), 4, "outside the film");
}

TEST_F(MitsubaLights, IntegratorsInsideOthers) {
    const std::string path = "<integrator type=\"path\"><integer name=\"max_depth\" value=\"4\"/></integrator>";
    for (const char* outer : {"moment", "aov", "stereo", "adaptive"})
        EXPECT_EQ(load_body("<integrator type=\"" + std::string(outer) + "\">" + path + "</integrator>").max_depth, 4) << outer;
    EXPECT_EQ(load_body("<integrator type=\"newest\"/>").max_depth, -1);
    EXPECT_EQ(load_body("<integrator type=\"$integrator\"><integer name=\"maxDepth\" value=\"5\"/></integrator>").max_depth, 5);
}

}  // namespace
}  // namespace pencil::test
