// Which emitters are point samples and which are carried by the maps.
#include <gtest/gtest.h>

#include "pencils/light_samples.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A floor of 2 x 2, and an emitter of `size` x `size` at a height above it.
LightForm form_of_emitter(double size, double height) {
    Scene scene;
    add_quad(scene, "floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
    add_quad(scene, "lamp", {-size / 2, height, -size / 2}, {size, 0, 0}, {0, 0, size}, {glm::vec3(0.0F), glm::vec3(1.0F), false});
    return choose_light_forms(scene, false, false)[1];
}

TEST(LightForms, LargeEmittersAreCarriedByTheMaps) {
    EXPECT_EQ(form_of_emitter(0.4, 1), LightForm::samples) << "4 % of the surface";
    EXPECT_EQ(form_of_emitter(1, 1), LightForm::maps);
    EXPECT_EQ(form_of_emitter(100, 20), LightForm::maps) << "a ceiling of the world";
}

TEST(LightForms, WhatIsSmallFromAfarIsSampledHoweverLargeItIs) {
    EXPECT_EQ(form_of_emitter(20, 100), LightForm::samples);
    EXPECT_EQ(form_of_emitter(2e5, 1e6), LightForm::samples);
}

TEST(LightForms, AnEmitterAroundTheSceneIsNotFar) {
    Scene scene;
    const Surface light{glm::vec3(0.0F), glm::vec3(1.0F), false};
    add_quad(scene, "floor", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
    add_box(scene, {-1e4, -1e4, -1e4}, {1e4, 1e4, 1e4}, light, true);
    for (std::size_t i = 1; i < scene.shapes.size(); ++i) EXPECT_EQ(choose_light_forms(scene, false, false)[i], LightForm::maps);
}

TEST(LightForms, OptionsOverrideBoth) {
    Scene scene;
    add_quad(scene, "lamp", {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, {glm::vec3(0.5F), glm::vec3(1.0F), false});
    EXPECT_EQ(choose_light_forms(scene, true, false)[0], LightForm::samples);
    EXPECT_EQ(choose_light_forms(scene, false, true)[0], LightForm::maps);
    EXPECT_EQ(choose_light_forms(scene, false, false)[0], LightForm::maps) << "nothing that it is far from";
}

}  // namespace
