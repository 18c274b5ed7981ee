// Lights of all kinds against closed forms.
#include "reference/environment_light.h"
#include "reference/lamp.h"
#include "reference_renderer/test_images.h"
#include "reference_renderer/traced.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A floor that is seen at one point.
Scene floor_at(double x, double z) {
    Scene scene;
    add_quad(scene, "floor", {-4, 0, -4}, {0, 0, 8}, {8, 0, 0}, {glm::vec3(0.75F), glm::vec3(0.0F), false});
    look_at(scene, {x, 0.1, z}, {x, 0, z}, {0, 0, 1}, 0.2, 8, 8);
    return scene;
}

TEST(Lights, SpotFallsLinearlyInTheAngle) {
    PointLight light{{0, 2, 0}, glm::vec3(3.0F)};
    light.is_spot = true;
    light.to_world = towards({0, -1, 0});
    light.cutoff = 40;
    light.beam_width = 20;
    for (const double degrees : {0.0, 19.0, 30.0, 39.0, 41.0}) {
        const double angle = glm::radians(degrees), c = std::cos(angle);
        Scene scene = floor_at(2 * std::tan(angle), 0);
        scene.point_lights.push_back(light);
        const double share = std::min(std::max((40 - degrees) / 20, 0.0), 1.0);
        const double expected = 0.75 / ref::pi * 3.0 * share * c * c * c / 4;
        const Layer image = layer(trace(scene, 16).layers, "");
        if (expected > 0)
            expect_uniform(image, expected, 1e-2);
        else
            expect_zero(image);
    }
}

TEST(Lights, ProfilesAreTables) {
    LightProfile profile;
    profile.vertical = {0, 60, 90};
    profile.horizontal = {0, 90, 180, 270, 360};
    profile.values = {1, 0.5F, 0, 1, 0.25F, 0, 1, 0.5F, 0, 1, 0.25F, 0, 1, 0.5F, 0};
    PointLight light{{0, 2, 0}, glm::vec3(3.0F)};
    light.profile = 0;
    const auto factor = [&](double vertical, double horizontal) {
        const double v = glm::radians(vertical), h = glm::radians(horizontal);
        return lamp_factor(light, {profile}, {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), std::cos(v)});
    };
    EXPECT_NEAR(factor(0, 12), 1.0, 1e-6);
    EXPECT_NEAR(factor(30, 0), 0.75, 1e-6);
    EXPECT_NEAR(factor(30, 90), 0.625, 1e-6);
    EXPECT_NEAR(factor(60, 45), 0.375, 1e-6);
    EXPECT_NEAR(factor(60, 315), 0.375, 1e-6);
    EXPECT_NEAR(factor(75, 180), 0.25, 1e-6);
    EXPECT_EQ(factor(120, 0), 0.0);
    light.profile = -1;
    EXPECT_NEAR(lamp_extent(light, {}), 4 * ref::pi, 1e-3);
}

TEST(Lights, ParallelLight) {
    Scene scene = floor_at(1, 2);
    const dvec3 travel = glm::normalize(dvec3(1, -2, 0.5));
    scene.directional_lights.push_back({travel, glm::vec3(2.0F)});
    expect_uniform(layer(trace(scene, 4).layers, ""), 0.75 / ref::pi * 2.0 * -travel.y, 1e-4);
    // Light from far away and from nearby share the samples.
    scene.point_lights.push_back({{1, 2, 2}, glm::vec3(3.0F)});
    expect_mean(trace(scene, 256), 0.75 / ref::pi * (3.0 / 4 - 2.0 * travel.y), 1e-2, "two lights");
}

TEST(Lights, MapIsSampledAsItSays) {
    const Environment map = random_map();
    const EnvironmentLight light(map);
    ref::Random random(6);
    double sampled = 0, uniform = 0, density = 0;
    constexpr int count = 400000;
    for (int i = 0; i < count; ++i) {
        const EnvironmentLight::Sample s = light.sample({random.uniform(), random.uniform()});
        ASSERT_GT(s.density, 0.0F);
        if (i % 16 == 0) {
            ASSERT_NEAR(light.density(s.direction), s.density, 1e-3F * s.density);
            ASSERT_NEAR(light.radiance(s.direction).x, s.radiance.x, 1e-3F * s.radiance.x + 1e-4F);
        }
        sampled += static_cast<double>(s.radiance.x / s.density) / count;
        const glm::vec3 d(random.direction());
        uniform += 4 * ref::pi * light.radiance(d).x / count;
        density += 4 * ref::pi * light.density(d) / count;
    }
    EXPECT_NEAR(density, 1, 0.02);
    EXPECT_NEAR(sampled, uniform, 0.02 * uniform);
    EXPECT_NEAR(light.flux(), sampled, 0.05 * sampled);
}

/// A diffuse floor under a map, by light sampling, and by the integral over directions.
TEST(Lights, FloorUnderAMap) {
    Scene scene = floor_at(0, 0);
    scene.environment = random_map();
    const EnvironmentLight light(*scene.environment);
    double expected = 0;
    constexpr int rows = 1000, columns = 1000;
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < columns; ++k) {
            const double y = (i + 0.5) / rows, phi = 2 * ref::pi * (k + 0.5) / columns, r = std::sqrt(1 - y * y);
            expected +=
                0.75 / ref::pi * y * light.radiance(glm::vec3(r * std::cos(phi), y, r * std::sin(phi))).x * 2 * ref::pi / (rows * columns);
        }
    expect_mean(trace(scene, 4096, 2), expected, 5e-3, "map");
}

TEST(Lights, LampsHaveTextures) {
    Scene scene;
    add_quad(scene, "lamp", {-1, -1, 0}, {2, 0, 0}, {0, 2, 0}, {glm::vec3(0.0F), glm::vec3(2.0F), false});
    for (const dvec3& p : scene.positions) scene.uvs.push_back(0.5F * glm::vec2(p) + 0.5F);
    Texture texture = bitmap(2, 1, {1.0F, 3.0F});
    texture.nearest = true;
    scene.textures.push_back(texture);
    scene.shapes[0].radiance_texture = 0;
    look_at(scene, {0, 0, 1}, dvec3(0), {0, 1, 0}, 60.0, 2, 1);
    const Layer image = layer(trace(scene, 4).layers, "");
    EXPECT_FLOAT_EQ(static_cast<float>(pixel(image, 0).x), 2.0F);
    EXPECT_FLOAT_EQ(static_cast<float>(pixel(image, 1).x), 6.0F);
    // It lights a floor with its mean if that sees both halves alike.
    add_quad(scene, "wall", {-1, -1, 3}, {0, 2, 0}, {2, 0, 0}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
    scene.uvs.resize(scene.positions.size());
    look_at(scene, {0, 0, 2.9}, {0, 0, 3}, {0, 1, 0}, 0.5, 4, 4);
    const Estimate textured = mean_of_image(trace(scene, 4096, 2));
    scene.shapes[0].radiance_texture = no_texture;
    scene.shapes[0].radiance = glm::vec3(4.0F);
    const Estimate plain = mean_of_image(trace(scene, 4096, 2));
    EXPECT_NEAR(textured.mean, plain.mean, 3 * textured.error + 3 * plain.error);
    EXPECT_LT(textured.error, 0.01 * plain.mean);
}

}  // namespace
