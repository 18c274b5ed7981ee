// Cameras of all kinds against closed forms.
#include "reference/environment_light.h"
#include "reference_renderer/test_images.h"
#include "reference_renderer/traced.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A wall z = 0 that shines in random squares, for cameras at z > 0.
Scene pattern() {
    Scene scene;
    ref::Random random(8);
    for (int x = -8; x < 8; ++x)
        for (int y = -8; y < 8; ++y)
            add_quad(scene, "square", {0.25 * x, 0.25 * y, 0}, {0.25, 0, 0}, {0, 0.25, 0},
                     {glm::vec3(0.0F), glm::vec3(static_cast<float>(0.2 + random.uniform())), false});
    return scene;
}

void expect_same_image(const Layer& a, const Layer& b, double tolerance) {
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    for (std::size_t i = 0; i < a.pixels.size(); ++i) ASSERT_NEAR(a.pixels[i], b.pixels[i], tolerance) << i;
}

TEST(Cameras, CropIsAPartOfTheFilm) {
    Scene scene = pattern();
    look_at(scene, {0.1, 0.2, 3}, {0, 0, 0}, {0, 1, 0}, 50.0, 24, 16);
    scene.sensor.principal_point_offset = {0.1, -0.05};
    scene.sensor.filter.kind = ReconstructionFilter::Kind::gaussian;
    scene.sensor.filter.radius = 2;
    const Layer whole = layer(trace(scene, 4096).layers, "");
    scene.sensor.crop_x = 0;  // at the border of the film, where its filter ends
    scene.sensor.crop_y = 5;
    scene.sensor.crop_width = 10;
    scene.sensor.crop_height = 6;
    const ReferenceResult part = trace(scene, 4096);
    ASSERT_EQ(part.width, 10);
    ASSERT_EQ(part.height, 6);
    for (std::size_t y = 0; y < 6; ++y)
        for (std::size_t x = 0; x < 10; ++x)
            ASSERT_NEAR(pixel(part.layers[0], 10 * y + x).x, pixel(whole, 24 * (y + 5) + x).x, 0.01) << x << ", " << y;
    // Twice the resolution shows the same part.
    ReferenceOptions options;
    options.width = 20;
    options.height = 12;
    scene.sensor.filter.kind = ReconstructionFilter::Kind::box;
    scene.sensor.filter.radius = 0.5;
    const ReferenceResult fine = trace_paths(scene, options), coarse = trace(scene, 4096);
    ASSERT_EQ(fine.width, 20);
    for (std::size_t y = 0; y < 6; ++y)
        for (std::size_t x = 0; x < 10; ++x) {
            double sum = 0;
            for (std::size_t k = 0; k < 4; ++k) sum += pixel(fine.layers[0], 20 * (2 * y + k / 2) + 2 * x + k % 2).x / 4;
            ASSERT_NEAR(sum, pixel(coarse.layers[0], 10 * y + x).x, 0.02);
        }
}

TEST(Cameras, OrthographicSeesWithoutPerspective) {
    Scene scene = pattern();
    look_at(scene, {0.1, 0.2, 3}, {0.1, 0.2, 0}, {0, 1, 0}, 50.0, 8, 4);
    scene.sensor.orthographic = true;
    for (int k = 0; k < 2; ++k) scene.sensor.to_world[k] *= 0.75;
    ReferenceOptions options;
    options.spp = 1024;
    options.surfaces = true;
    const ReferenceResult result = trace_paths(scene, options);
    const Layer& position = layer(result.layers, "position");
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x) {
            const dvec3 p = pixel(position, static_cast<std::size_t>(8 * y + x));
            ASSERT_NEAR(p.x, 0.1 + 0.75 * (2 * (x + 0.5) / 8 - 1), 1e-3);
            ASSERT_NEAR(p.y, 0.2 + 0.75 * (0.5 - (y + 0.5) / 4), 1e-3);
        }
    scene.sensor.to_world[3].z = 2;
    expect_same_image(layer(trace_paths(scene, options).layers, ""), result.layers[0], 0.01);
}

/// What lies in the plane of focus is as sharp as by a pinhole; elsewhere a lens spreads a point over its own image.
TEST(Cameras, ThinLensIsSharpInFocus) {
    Scene scene = pattern();
    look_at(scene, {0.1, 0.2, 3}, {0.1, 0.2, 0}, {0, 1, 0}, 30.0, 16, 16);
    const Layer pinhole = layer(trace(scene, 1024).layers, "");
    scene.sensor.aperture_radius = 0.2;
    scene.sensor.focus_distance = 3;
    expect_same_image(layer(trace(scene, 1024).layers, ""), pinhole, 0.01);
    scene.sensor.focus_distance = 1.5;
    const Layer blurred = layer(trace(scene, 1024).layers, "");
    double sharp = 0, soft = 0;
    for (std::size_t i = 1; i < pixel_count(pinhole); ++i) {
        sharp += std::abs(pixel(pinhole, i).x - pixel(pinhole, i - 1).x);
        soft += std::abs(pixel(blurred, i).x - pixel(blurred, i - 1).x);
    }
    EXPECT_LT(soft, 0.6 * sharp);
}

TEST(Cameras, SkyIsSeenDirectly) {
    Scene scene;
    scene.environment = random_map();
    look_at(scene, {0, 0, 0}, {0.3, 1, -0.2}, {0, 0, 1}, 1.0, 4, 4);
    const Layer image = layer(trace(scene, 256).layers, "");
    const EnvironmentLight light(*scene.environment);
    double mean = 0;
    for (std::size_t i = 0; i < 16; ++i) mean += pixel(image, i).x / 16;
    EXPECT_NEAR(mean, light.radiance(glm::normalize(glm::vec3(0.3F, 1.0F, -0.2F))).x, 1e-3 * mean);
}

}  // namespace
