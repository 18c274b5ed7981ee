// Lights and cameras of glTF files, and what stands in for them.
#include <cmath>
#include <glm/geometric.hpp>

#include "unit/gltf_fixture.h"

namespace pencil::test {
namespace {

class GltfLights : public GltfTest {
protected:
    using Json = GltfBuilder::Json;

    /// A triangle and a light at a node a quarter turn about y, so that its -z axis is the world's -x.
    Scene scene_with(const Json& light) const {
        GltfBuilder builder;
        builder.triangle();
        const double half = std::sqrt(0.5);
        builder.add("nodes", {{"rotation", {0, half, 0, half}},
                              {"translation", {1, 2, 3}},
                              {"extensions", {{"KHR_lights_punctual", {{"light", builder.light(light)}}}}}});
        return load(builder);
    }
    Scene seen_by(const Json& camera) const {
        GltfBuilder builder;
        builder.triangle();
        builder.add("cameras", camera);
        builder.add("nodes", {{"camera", 0}, {"translation", {0, 0, 5}}, {"scale", {2, 2, 2}}});
        return load(builder);
    }
};

TEST_F(GltfLights, PointsInCandela) {
    const Scene scene = scene_with({{"type", "point"}, {"intensity", 683}, {"color", {1, 0.5, 0.25}}});
    ASSERT_EQ(scene.point_lights.size(), 1U);
    EXPECT_EQ(scene.point_lights[0].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(scene.point_lights[0].intensity, glm::vec3(1, 0.5F, 0.25F));
    EXPECT_FALSE(scene.point_lights[0].is_spot);
    EXPECT_FALSE(scene.environment);
}

TEST_F(GltfLights, SpotsPointAlongTheirAxis) {
    const Scene scene =
        scene_with({{"type", "spot"}, {"intensity", 1366}, {"range", 9}, {"spot", {{"innerConeAngle", 0.5}, {"outerConeAngle", 1.0}}}});
    ASSERT_EQ(scene.point_lights.size(), 1U);
    const PointLight& light = scene.point_lights[0];
    EXPECT_TRUE(light.is_spot);
    EXPECT_EQ(light.intensity, glm::vec3(2));
    expect_near(light.to_world * glm::dvec3(0, 0, 1), {-1, 0, 0}, 1e-12);
    EXPECT_NEAR(light.cutoff, 57.29578, 1e-4);
    EXPECT_NEAR(light.beam_width, 28.64789, 1e-4);
    EXPECT_TRUE(has_warning(scene, "range"));
}

TEST_F(GltfLights, DirectionalInLux) {
    const Scene scene = scene_with({{"type", "directional"}, {"intensity", 683}});
    ASSERT_EQ(scene.directional_lights.size(), 1U);
    expect_near(scene.directional_lights[0].direction, {-1, 0, 0}, 1e-12);
    EXPECT_EQ(scene.directional_lights[0].irradiance, glm::vec3(1));
}

TEST_F(GltfLights, DefectsOfLights) {
    const auto message = [&](const Json& light) {
        GltfBuilder builder;
        builder.triangle();
        builder.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", builder.light(light)}}}}}});
        return message_of(builder.gltf());
    };
    EXPECT_NE(message({{"type", "laser"}}).find("unknown type \"laser\""), std::string::npos);
    EXPECT_NE(message({{"type", "point"}, {"intensity", -1}}).find("intensity"), std::string::npos);
    EXPECT_NE(message({{"type", "point"}, {"color", {1, 1}}}).find("2 numbers"), std::string::npos);
    EXPECT_NE(message({{"type", "spot"}, {"spot", {{"innerConeAngle", 1.0}, {"outerConeAngle", 0.5}}}}).find("angles"), std::string::npos);
    GltfBuilder builder;
    builder.triangle();
    builder.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 3;
    expect_message(builder, "names light 3, but there are 0");
}

TEST_F(GltfLights, PerspectiveCameras) {
    const Scene scene =
        seen_by({{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"aspectRatio", 2.0}, {"znear", 0.5}, {"zfar", 6}}}});
    const PerspectiveSensor& sensor = scene.sensor;
    EXPECT_EQ(sensor.width, 768);
    EXPECT_EQ(sensor.height, 384);
    EXPECT_NEAR(sensor.fov_x, 2 * 180 / std::acos(-1.0) * std::atan(2 * std::tan(0.5)), 1e-9);
    EXPECT_EQ(sensor.near_clip, 0.5);
    EXPECT_GT(sensor.far_clip, 1e6);
    expect_near(glm::dvec3(sensor.to_world * glm::dvec4(0, 0, 1, 0)), {0, 0, -1}, 1e-12);  // looks along
    expect_near(glm::dvec3(sensor.to_world * glm::dvec4(1, 0, 0, 0)), {-1, 0, 0}, 1e-12);  // to its left
    expect_near(glm::dvec3(sensor.to_world * glm::dvec4(0, 1, 0, 0)), {0, 1, 0}, 1e-12);
    expect_near(glm::dvec3(sensor.to_world[3]), {0, 0, 5}, 1e-12);
    EXPECT_FALSE(has_warning(scene, "no camera"));
}

TEST_F(GltfLights, UprightAndUnstatedFilms) {
    const Scene upright = seen_by({{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"aspectRatio", 0.5}, {"znear", 1}}}});
    EXPECT_EQ(upright.sensor.width, 384);
    EXPECT_EQ(upright.sensor.height, 768);
    const Scene unstated = seen_by({{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 1}}}});
    EXPECT_EQ(unstated.sensor.width, 768);
    EXPECT_EQ(unstated.sensor.height, 576);
}

TEST_F(GltfLights, OrthographicCameras) {
    const Scene scene = seen_by({{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 1.5}, {"znear", 0.1}, {"zfar", 9}}}});
    EXPECT_TRUE(scene.sensor.orthographic);
    EXPECT_EQ(scene.sensor.height, 384);
    expect_near(glm::dvec3(scene.sensor.to_world[0]), {-3, 0, 0}, 1e-12);
    expect_near(glm::dvec3(scene.sensor.to_world[1]), {0, 3, 0}, 1e-12);
    expect_near(glm::dvec3(scene.sensor.to_world[2]), {0, 0, -1}, 1e-12);
}

TEST_F(GltfLights, DefectsOfCameras) {
    const auto message = [&](const Json& camera) {
        GltfBuilder builder;
        builder.triangle();
        builder.add("cameras", camera);
        builder.add("nodes", {{"camera", 0}});
        return message_of(builder.gltf());
    };
    EXPECT_NE(message({{"type", "perspective"}, {"perspective", {{"yfov", 4.0}, {"znear", 1}}}}).find("yfov"), std::string::npos);
    EXPECT_NE(message({{"type", "perspective"}, {"perspective", {{"yfov", 1.0}, {"znear", 0}}}}).find("znear"), std::string::npos);
    EXPECT_NE(message({{"type", "orthographic"}, {"orthographic", {{"xmag", 0}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}}).find("xmag"),
              std::string::npos);
    EXPECT_NE(message({{"type", "fisheye"}}), "");
}

TEST_F(GltfLights, WithoutEitherTheSceneIsFramedUnderASky) {
    GltfBuilder builder;
    builder.triangle();
    builder.json["nodes"][0]["scale"] = {100, 100, 100};
    const Scene scene = load(builder);
    EXPECT_TRUE(has_warning(scene, "there is no camera"));
    EXPECT_TRUE(has_warning(scene, "there is no light"));
    ASSERT_TRUE(scene.environment && scene.environment->is_map());
    EXPECT_EQ(scene.environment->texels.size(), static_cast<std::size_t>(scene.environment->width * scene.environment->height));
    const PerspectiveSensor& sensor = scene.sensor;
    const double most = std::tan(sensor.fov_x / 2 * std::acos(-1.0) / 180), aspect = static_cast<double>(sensor.width) / sensor.height;
    double widest = 0;
    for (const glm::dvec3& p : scene.positions) {
        const glm::dvec3 seen = glm::transpose(glm::dmat3(sensor.to_world)) * (p - glm::dvec3(sensor.to_world[3]));
        EXPECT_GT(seen.z, sensor.near_clip);
        widest = std::max({widest, std::abs(seen.x / seen.z), std::abs(seen.y / seen.z) * aspect});
    }
    EXPECT_LT(widest, most);
    EXPECT_GT(widest, 0.5 * most);
}

}  // namespace
}  // namespace pencil::test
