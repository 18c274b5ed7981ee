// Illuminance and luminance as layers of an image.
#include <glm/gtc/packing.hpp>

#include "reference/path_tracer.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A floor under a point light, seen straight from above; half of it is a mirror-like metal.
Scene lit_floor() {
    Scene scene;
    add_quad(scene, "left", {-1, 0, -1}, {0, 0, 2}, {1, 0, 0}, {glm::vec3(0.1F, 0.4F, 0.0F), glm::vec3(0.0F), false});
    add_quad(scene, "right", {0, 0, -1}, {0, 0, 2}, {1, 0, 0}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
    scene.materials.back().model = MATERIAL_CONDUCTOR;
    scene.materials.back().alpha = glm::vec2(0.3F);
    scene.materials.back().perfect_mirror = true;
    scene.point_lights.push_back({{0, 2, 0}, glm::vec3(50.0F)});
    look_at(scene, {0, 1, 0}, {0, 0, 0}, {0, 0, 1}, 90.0, 16, 16);
    return scene;
}

/// At the middle of each pixel: columns run from +x to -x or back, the light is in the middle.
double expected_at(std::size_t pixel) {
    const double x = (static_cast<double>(pixel % 16) + 0.5) / 8 - 1, z = (static_cast<double>(pixel / 16) + 0.5) / 8 - 1;
    return 50 * 2 / std::pow(x * x + z * z + 4, 1.5);
}

TEST(PhotometricLayers, IlluminanceDoesNotDependOnTheMaterial) {
    RenderOptions options;
    options.lumens_per_watt = 10;
    options.bounces = 1;
    options.aovs = {illuminance_layer, luminance_layer};
    const RenderResult result = render(lit_floor(), options, device());
    const Layer &illuminance = layer(result, illuminance_layer), &luminance = layer(result, luminance_layer), &beauty = layer(result, "");
    ASSERT_EQ(illuminance.channels, 1);
    ASSERT_EQ(illuminance.pixels.size(), 256U);
    double sum = 0, expected = 0;
    for (std::size_t i = 0; i < 256; ++i) {
        EXPECT_NEAR(illuminance.pixels[i], 10 * expected_at(i), 0.05 * 10 * expected_at(i))
            << "a pixel shows one point in each pass, " << i;
        sum += static_cast<double>(illuminance.pixels[i]);
        expected += 10 * expected_at(i);
        const dvec3 rgb = pixel(beauty, i);
        EXPECT_NEAR(luminance.pixels[i], 10 * (0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z), 1e-3);
    }
    EXPECT_NEAR(sum / expected, 1, 0.003);
}

/// A meter that is laid on a relief does not follow its texture.
TEST(PhotometricLayers, IlluminanceDoesNotDependOnRelief) {
    Scene scene = lit_floor();
    for (const dvec3& p : scene.positions) scene.uvs.emplace_back(p.x, p.z);
    Texture slope;
    slope.width = slope.height = 1;
    slope.texels = {glm::packHalf(glm::vec4(0.8F, 0.5F, 0.9F, 1.0F))};  // turned towards u by atan(0.6 / 0.8)
    scene.textures.push_back(slope);
    for (SceneMaterial& material : scene.materials) material.normal_texture = 0;
    RenderOptions options;
    options.lumens_per_watt = 1;
    options.bounces = 1;
    options.irradiance = true;
    const Layer rendered = layer(render_layers(scene, options), "");
    ReferenceOptions traced;
    traced.irradiance = true;
    traced.spp = 16;
    traced.max_depth = 2;
    const Layer reference = trace_paths(scene, traced).layers.front();
    for (std::size_t i = 0; i < 256; ++i)
        for (const Layer* image : {&rendered, &reference})
            EXPECT_NEAR(ref::pi * pixel(*image, i).x, expected_at(i), 0.05 * expected_at(i)) << i;
}

TEST(PhotometricLayers, TheReferenceAgrees) {
    const Scene scene = room_of_everything();
    RenderOptions options;
    options.lumens_per_watt = 1;
    options.target_error = 1e-2;
    options.aovs = {illuminance_layer};
    const RenderResult rendered = render(scene, options, device());
    ReferenceOptions traced;
    traced.irradiance = true;
    traced.spp = 1024;
    const ReferenceResult reference = trace_paths(scene, traced);
    double ours = 0, theirs = 0;
    for (std::size_t i = 0; i < pixel_count(reference.layers.front()); ++i) {
        const dvec3 rgb = pixel(reference.layers.front(), i);
        theirs += ref::pi * (0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z);
        ours += static_cast<double>(layer(rendered, illuminance_layer).pixels.at(i));
    }
    EXPECT_NEAR(ours / theirs, 1, 0.01);
}

TEST(PhotometricLayers, CostNothingUnlessTheyAreNamed) {
    RenderOptions options;
    options.bounces = 1;
    const RenderResult result = render(lit_floor(), options, device());
    for (const Layer& made : result.layers) EXPECT_TRUE(made.name != illuminance_layer && made.name != luminance_layer);
    for (const StageTime& stage : result.stats.stages) EXPECT_NE(stage.name, illuminance_layer);
}

}  // namespace
