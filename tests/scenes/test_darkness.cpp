// Where no light goes there is exactly none: behind walls, without emitters, without albedo, without geometry.
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

const Surface white{glm::vec3(0.8F), glm::vec3(0.0F), false};

RenderOptions options(Initial initial) {
    RenderOptions out = line_options();
    out.initial = initial;
    out.pencils = 64;
    out.map = 32;
    out.bounces = 3;
    out.film_samples = 4;
    return out;
}

double mean(const Layer& image) {
    double sum = 0.0;
    for (const float value : image.pixels) sum += value;
    return sum / static_cast<double>(image.pixels.size());
}

/// Mean radiance of the dark room relative to the lit one. Direct light of light samples must be exactly 0 in the dark.
double leak(double thickness, bool lamp_is_area, Initial initial, int map, Weights weights = Weights::dpdf) {
    RenderOptions o = options(initial);
    o.weights = weights;
    o.map = map;
    Scene scene = two_rooms(thickness, lamp_is_area);
    const RenderResult dark = render_layers(scene, o, {"direct"});
    if (initial == Initial::direct) expect_zero(layer(dark, "direct"));
    look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 64, 64);
    return mean(layer(dark, "")) / mean(layer(render_layers(scene, o), ""));
}

// Where wall, floor and sheet meet in one point, that point may lie between the texels of a map: a surfel there is lit from behind now and
// then. Measured 6e-9 for maps that carry emission, 0 otherwise.
constexpr double corner_leak = 1e-7;

TEST(Darkness, NoLightThroughASheet) {
    for (const auto& [area, initial] :
         {std::pair{false, Initial::direct}, std::pair{true, Initial::direct}, std::pair{true, Initial::emission}}) {
        SCOPED_TRACE(std::string(area ? "area" : "point") + (initial == Initial::direct ? " direct" : " emission"));
        const double coarse = leak(0.0, area, initial, 32), fine = leak(0.0, area, initial, 64);
        std::printf("leak through a sheet, relative: %.2e with map 32, %.2e with map 64\n", coarse, fine);
        EXPECT_LE(coarse, corner_leak);
        EXPECT_LE(fine, corner_leak);
    }
}

/// The film shows a lit room and, where it cuts a closed box, the inside of that: no pencil in the room may stand for what lies in the box.
TEST(Darkness, NoLightInAClosedBoxThatTheFilmCuts) {
    Scene scene;
    add_box(scene, {0, 0, 0}, {1, 1, 1}, {glm::vec3(0.7F), glm::vec3(0.0F), false});
    add_box(scene, {0.55, 0.55, 0.3}, {0.65, 0.65, 0.7}, {glm::vec3(0.7F), glm::vec3(0.0F), true}, false);
    add_quad(scene, "lamp", {0.4, 0.99, 0.4}, {0.2, 0, 0}, {0, 0, 0.2}, {glm::vec3(0.0F), glm::vec3(5.0F), false});
    look_at(scene, {0.5, 0.5, 0.5}, {0.5, 0.5, 1}, {0, 1, 0}, 90.0, 40, 40);
    scene.sensor.orthographic = true;
    for (int column = 0; column < 3; ++column) scene.sensor.to_world[column] *= 0.5;
    RenderOptions o;
    o.target_error = 0.05;
    o.pencils = 2;  // so few that none need lie in the box
    const Layer image = layer(render_layers(scene, o), "");
    double inside = 0, all = 0;
    for (std::size_t i = 0; i < pixel_count(image); ++i) {
        const std::size_t x = i % 40, y = i / 40;
        all += pixel(image, i).x;
        if (x > 14 && x < 17 && y > 14 && y < 17) inside += pixel(image, i).x;
    }
    std::printf("light in a closed box, relative to all: %.2e\n", inside / all);
    EXPECT_GT(all, 0);
    EXPECT_LT(inside / all, 2e-4) << "3.8e-4 where pencils behind walls stand in; 0 with as many pencils as usual";
}

TEST(Darkness, NoLightThroughAWall) {
    for (const double thickness : {0.1, 0.004}) {
        SCOPED_TRACE(thickness);
        const double point = leak(thickness, false, Initial::direct, 32), area = leak(thickness, true, Initial::emission, 32);
        std::printf("leak through a wall of %g, relative: %.2e direct, %.2e emission\n", thickness, point, area);
        EXPECT_LE(point, corner_leak);
        EXPECT_LE(area, corner_leak);
    }
}

// The same point, weighted by the large cell or the short free path that a direction next to a wall has. Measured 9e-7.
constexpr double corner_leak_of_wide_cells = 3e-6;

TEST(Darkness, NoLightThroughASheetWithAnyWeights) {
    for (const Weights weights : {Weights::voronoi, Weights::analytic, Weights::thesis}) {
        EXPECT_LE(leak(0.0, true, Initial::direct, 32, weights), 0.0);
        EXPECT_LE(leak(0.0, true, Initial::emission, 32, weights), corner_leak_of_wide_cells);
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
    for (SceneMaterial& material : scene.materials) material.albedo = {0.9F, 0.0F, 0.0F};
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
    one.map = 8;
    one.film_samples = 1;
    const RenderResult result = render_layers(scene, one);
    ASSERT_EQ(layer(result, "").pixels.size(), 3U);
    EXPECT_NEAR(layer(result, "").pixels[0], 0.8 / 3.14159265 * 3.0, 1e-3);
}

}  // namespace
