// Direct light alone against closed forms: a point light over a plane and in a sphere, a polygon over a plane.
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr double floor_albedo = 0.75;
const Surface grey_floor{glm::vec3(0.75F), glm::vec3(0.0F), false};

RenderOptions direct_options() {
    RenderOptions options = line_options();
    options.initial = Initial::direct;
    options.bounces = 1;
    options.pencils = 8;
    options.map = 16;
    return options;
}

Scene floor_seen_from_above() {
    Scene scene;
    add_quad(scene, "floor", {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, grey_floor);
    look_at(scene, {0.1, 2.2, 0.05}, {0.1, 0, 0.05}, {0, 0, 1}, 60.0, 96, 96);
    return scene;
}

TEST(DirectLight, PointLightOverAPlane) {
    Scene scene = floor_seen_from_above();
    const dvec3 light(0.2, 0.8, -0.3), intensity(3.0, 1.0, 0.25);
    scene.point_lights.push_back({light, intensity});
    const RenderResult result = render_layers(scene, direct_options(), {"direct", "position"});
    const Layer &direct = layer(result, "direct"), &position = layer(result, "position");
    ASSERT_EQ(pixel_count(direct), 96U * 96U);
    for (std::size_t i = 0; i < pixel_count(direct); ++i) {
        const dvec3 to_light = light - pixel(position, i);
        const double r = glm::length(to_light);
        const dvec3 expected = floor_albedo / ref::pi * intensity * (to_light.y / (r * r * r)), got = pixel(direct, i);
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(got[c], expected[c], 1e-3 * expected[c]) << "pixel " << i << " channel " << c;
    }
}

TEST(DirectLight, PointLightBehindAOneSidedFloorDoesNotShine) {
    Scene scene = floor_seen_from_above();
    scene.point_lights.push_back({{0.2, -0.8, -0.3}, glm::vec3(5.0F)});
    expect_zero(layer(render_layers(scene, direct_options()), ""));
}

TEST(DirectLight, ShadowOfAQuad) {
    Scene scene = floor_seen_from_above();
    add_quad(scene, "blocker", {-0.2, 0.4, -0.2}, {0, 0, 0.4}, {0.4, 0, 0}, {glm::vec3(0.0F), glm::vec3(0.0F), true});
    scene.point_lights.push_back({{0, 0.8, 0}, glm::vec3(1.0F)});
    // The shadow is the square |x|, |z| < 0.4; the camera sees it beside the blocker from the side.
    look_at(scene, {0, 0.3, -1.5}, {0, 0, 0}, {0, 1, 0}, 50.0, 96, 96);
    const RenderResult result = render_layers(scene, direct_options(), {"direct", "position"});
    const Layer &direct = layer(result, "direct"), &position = layer(result, "position");
    int dark = 0, lit = 0;
    for (std::size_t i = 0; i < pixel_count(direct); ++i) {
        const dvec3 p = pixel(position, i);
        if (std::abs(p.y) > 1e-5 || glm::length(p) == 0.0) continue;
        const double outside = std::max(std::abs(p.x), std::abs(p.z)) - 0.4;
        if (outside < -0.03) {
            ++dark;
            ASSERT_EQ(pixel(direct, i).x, 0.0) << "pixel " << i << " at " << p.x << " " << p.z;
        } else if (outside > 0.03) {
            ++lit;
            ASSERT_GT(pixel(direct, i).x, 0.0) << "pixel " << i << " at " << p.x << " " << p.z;
        }
    }
    EXPECT_GT(dark, 100);
    EXPECT_GT(lit, 100);
}

TEST(DirectLight, SphereWithAPointLightAtItsCentre) {
    Scene scene;
    add_shape(scene, "sphere", inward_sphere(2.0, 24), grey_floor);
    scene.point_lights.push_back({dvec3(0.0), glm::vec3(3.0F)});
    look_at(scene, {0.5, 0.3, -0.4}, {2, -0.2, 1}, {0, 1, 0}, 80.0, 48, 48);
    RenderOptions options = direct_options();
    options.bounces = -1;
    options.pencils = 64;
    options.map = 32;
    options.tolerance = 1e-4;
    const RenderResult result = render_layers(scene, options, {"direct"});
    const double direct = floor_albedo / ref::pi * 3.0 / 4.0;  // E = I / r^2
    expect_uniform(layer(result, "direct"), direct, 0.01);     // flat faces of 7.5 degrees: cos falls to 0.9957, 1 / r^2 rises by 0.9 %
    // Inside a sphere every point receives the same from every point: the series is geometric. Half of the bounding box lies outside.
    expect_uniform(layer(result, ""), direct / (1.0 - floor_albedo), 0.01);
}

TEST(DirectLight, PolygonByLambertsFormula) {
    Scene scene = floor_seen_from_above();
    const dvec3 corner(-0.5, 1.0, -0.3), u(0.9, 0, 0), v(0, 0, 0.6);
    add_quad(scene, "lamp", corner, u, v, {glm::vec3(0.0F), glm::vec3(2.0F), false});  // front looks down
    look_at(scene, {0.1, 0.9, 0.05}, {0.1, 0, 0.05}, {0, 0, 1}, 90.0, 64, 64);
    RenderOptions options = direct_options();
    options.light_samples = 1024;
    const RenderResult result = render_layers(scene, options, {"direct", "position"});
    const Layer &direct = layer(result, "direct"), &position = layer(result, "position");
    for (std::size_t i = 0; i < pixel_count(direct); ++i) {
        const dvec3 p = pixel(position, i);
        const double e = 2.0 * ref::polygon_irradiance({corner, corner + u, corner + u + v, corner + v}, p, {0, 1, 0});
        const double expected = floor_albedo / ref::pi * e;
        ASSERT_NEAR(pixel(direct, i).x, expected, 0.01 * expected) << "pixel " << i << " at " << p.x << " " << p.z;
    }
}

}  // namespace
