// The unit of light, and how layers come back from it.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "options/scale_light.h"
#include "scene/light_unit.h"

namespace {

using namespace pencil;

Scene lamp(const glm::vec3& radiance) {
    Scene scene;
    Shape shape;
    shape.emits = true;
    shape.radiance = radiance;
    scene.shapes.push_back(shape);
    return scene;
}

TEST(LightUnit, BringsTheStrongestBetweenOneAndTwo) {
    for (const float radiance : {1.0F, 1.5F, 17.0F, 1e-30F, 1e38F, 1e-40F, 0.1F}) {
        const double unit = light_unit(lamp({radiance, 0.5F * radiance, 0.0F})), scaled = static_cast<double>(radiance) / unit;
        EXPECT_GE(scaled, 1.0) << radiance;
        EXPECT_LT(scaled, 2.0) << radiance;
        int exponent = 0;
        EXPECT_EQ(std::frexp(unit, &exponent), 0.5) << "a power of two, for " << radiance;
    }
}

TEST(LightUnit, IsOneWithoutLight) {
    EXPECT_EQ(light_unit(Scene()), 1.0);
    EXPECT_EQ(light_unit(lamp(glm::vec3(0))), 1.0);
    Scene unlit = lamp(glm::vec3(100));
    unlit.shapes[0].emits = false;
    EXPECT_EQ(light_unit(unlit), 1.0);
}

TEST(LightUnit, KnowsAllEmitters) {
    Scene sun, sky, map;
    sun.directional_lights.push_back({{0, -1, 0}, glm::vec3(64)});
    EXPECT_EQ(light_unit(sun), 64.0);
    sky.environment = Environment{};
    sky.environment->radiance = glm::vec3(0.25F);
    EXPECT_EQ(light_unit(sky), 0.25);
    map.environment = Environment{};
    map.environment->width = map.environment->height = 1;
    map.environment->texels = {glm::vec3(4)};
    map.environment->radiance = glm::vec3(8);
    EXPECT_EQ(light_unit(map), 32.0);
    Scene point;  // 16 across: irradiance of 256 at that distance
    point.positions = {{0, 0, 0}, {16, 0, 0}};
    point.point_lights.push_back({{1, 0, 0}, glm::vec3(65536)});
    EXPECT_EQ(light_unit(point), 256.0);
}

TEST(ScaleLight, ScalesLightAndNothingElse) {
    std::vector<Layer> layers{
        {"", 3, {1, 2, 3}}, {"albedo", 3, {1, 2, 3}}, {"depth", 1, {5}}, {"variance", 3, {1, 1, 1}}, {"bounce2", 3, {0, 1, 4}}};
    EXPECT_TRUE(scale_light(8, layers).empty());
    EXPECT_EQ(layers[0].pixels, (std::vector<float>{8, 16, 24}));
    EXPECT_EQ(layers[1].pixels, (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(layers[2].pixels, (std::vector<float>{5}));
    EXPECT_EQ(layers[3].pixels, (std::vector<float>{64, 64, 64}));
    EXPECT_EQ(layers[4].pixels, (std::vector<float>{0, 8, 32}));
}

TEST(ScaleLight, SaysWhatLeavesTheRangeOfFloat) {
    constexpr float most = std::numeric_limits<float>::max();
    const float infinite = std::numeric_limits<float>::infinity();
    std::vector<Layer> layers{{"", 3, {1, 4, -4}}, {"direct", 3, {0, infinite, 1}}};
    const std::vector<std::string> large = scale_light(std::ldexp(1.0, 126), layers);
    ASSERT_EQ(large.size(), 1U);
    EXPECT_NE(large[0].find("2 values of the image are too large"), std::string::npos) << large[0];
    EXPECT_EQ(layers[0].pixels, (std::vector<float>{std::ldexp(1.0F, 126), most, -most}));
    EXPECT_EQ(layers[1].pixels[1], infinite);
    std::vector<Layer> dim{{"direct", 3, {0, 1, 0.25F}}};
    const std::vector<std::string> small = scale_light(std::ldexp(1.0, -126), dim);
    ASSERT_EQ(small.size(), 1U);
    EXPECT_NE(small[0].find("1 values of layer direct are too small"), std::string::npos) << small[0];
    EXPECT_EQ(dim[0].pixels[1], std::ldexp(1.0F, -126));
    EXPECT_EQ(dim[0].pixels[2], std::ldexp(1.0F, -128));
}

}  // namespace
