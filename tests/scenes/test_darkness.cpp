// Where no light goes there is exactly none: behind walls, without emitters, without albedo, without geometry.
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const Surface white{glm::vec3(0.8F), glm::vec3(0.0F), false}, white_both{glm::vec3(0.8F), glm::vec3(0.0F), true};

/// Two unit rooms side by side along x; the lit one is at x < 1. `thickness` 0: one two-sided sheet between them.
Scene two_rooms(double thickness, bool lamp_is_area) {
    Scene scene;
    add_box(scene, {0, 0, 0}, {2, 1, 1}, white);
    if (thickness > 0.0) {
        add_wall(scene, 1, {0, 0, 0}, {1 - thickness / 2, 1, 1}, white);
        add_wall(scene, 0, {1 + thickness / 2, 0, 0}, {2, 1, 1}, white);
    } else {
        add_quad(scene, "sheet", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, white_both);
    }
    if (lamp_is_area) {
        add_quad(scene, "lamp", {0.3, 0.95, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.0F), glm::vec3(10.0F), false});
    } else {
        scene.point_lights.push_back({{0.5, 0.9, 0.5}, glm::vec3(10.0F)});
    }
    look_at(scene, {1.9, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 95.0, 64, 64);
    return scene;
}

RenderOptions options(Initial initial) {
    RenderOptions out;
    out.initial = initial;
    out.pencils = 64;
    out.map = 32;
    out.bounces = 3;
    out.film_samples = 4;
    return out;
}

TEST(Darkness, NoLightThroughASheet) {
    expect_zero(layer(render_layers(two_rooms(0.0, false), options(Initial::direct)), ""));
    expect_zero(layer(render_layers(two_rooms(0.0, true), options(Initial::direct)), ""));
    expect_zero(layer(render_layers(two_rooms(0.0, true), options(Initial::emission)), ""));
}

TEST(Darkness, NoLightThroughAThinWall) {
    for (const double thickness : {0.1, 0.004}) {
        SCOPED_TRACE(thickness);
        expect_zero(layer(render_layers(two_rooms(thickness, false), options(Initial::direct)), ""));
        expect_zero(layer(render_layers(two_rooms(thickness, true), options(Initial::emission)), ""));
    }
}

TEST(Darkness, TheLitRoomIsLit) {
    Scene scene = two_rooms(0.0, true);
    look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 32, 32);
    for (const Initial initial : {Initial::direct, Initial::emission}) {
        const RenderResult result = render_layers(scene, options(initial));
        for (std::size_t i = 0; i < pixel_count(layer(result, "")); ++i) ASSERT_GT(pixel(layer(result, ""), i).x, 0.0) << "pixel " << i;
    }
}

TEST(Darkness, AlbedoZeroHasNoIndirectLight) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), {glm::vec3(0.0F), glm::vec3(0.0F), false});
    scene.point_lights.push_back({{0.5, 0.9, 0.5}, glm::vec3(10.0F)});
    look_at(scene, {0.1, 0.5, 0.1}, {0.9, 0.4, 0.9}, {0, 1, 0}, 90.0, 16, 16);
    expect_zero(layer(render_layers(scene, options(Initial::direct)), ""));
    for (Diffuse& bsdf : scene.bsdfs) bsdf.albedo = {0.9F, 0.0F, 0.0F};
    const RenderResult red = render_layers(scene, options(Initial::direct), {"direct", "bounces"});
    const Layer& second = layer(red, "bounce2");
    for (std::size_t i = 0; i < pixel_count(second); ++i) {
        ASSERT_GT(pixel(second, i).x, 0.0) << "pixel " << i;
        ASSERT_EQ(pixel(second, i).y, 0.0) << "pixel " << i;
    }
}

TEST(Darkness, NoLightIsBlack) {
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(1.0), white);
    look_at(scene, {0.1, 0.5, 0.1}, {0.9, 0.4, 0.9}, {0, 1, 0}, 90.0, 16, 16);
    for (const Initial initial : {Initial::direct, Initial::emission, Initial::automatic})
        expect_zero(layer(render_layers(scene, options(initial)), ""));
}

TEST(Darkness, NoGeometryIsBlack) {
    Scene scene;
    look_at(scene, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 90.0, 16, 16);
    expect_zero(layer(render_layers(scene, options(Initial::automatic)), ""));
    scene.point_lights.push_back({{0.5, 0.9, 0.5}, glm::vec3(10.0F)});
    expect_zero(layer(render_layers(scene, options(Initial::automatic)), ""));
}

TEST(Darkness, OneTriangleOnePixelOnePencil) {
    Scene scene;
    add_shape(scene, "triangle", {{dvec3(-1, -1, 1), dvec3(0, 2, 1), dvec3(1, -1, 1)}}, white);  // front looks to -z, at the camera
    scene.point_lights.push_back({{0, 0, 0}, glm::vec3(3.0F)});
    look_at(scene, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.0, 1, 1);
    RenderOptions one = options(Initial::automatic);
    one.pencils = 1;
    one.map = 2;
    one.film_samples = 1;
    const RenderResult result = render_layers(scene, one);
    ASSERT_EQ(layer(result, "").pixels.size(), 3U);
    EXPECT_NEAR(layer(result, "").pixels[0], 0.8 / 3.14159265 * 3.0, 1e-3);
}

}  // namespace
