// Hierarchical iteration: the same light as by sets, all orders that were asked for, and no others.
#include "film/film_layers.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace pencil::test {
namespace {

constexpr double promised = 1e-3;

RenderOptions level_options() {
    RenderOptions options = line_options();
    options.iterate = Iterate::levels;
    options.pencils = 128;  // over one of 32
    options.map = 32;
    options.film_samples = 4;
    return options;
}

TEST(Levels, CarryTheWholeSeries) {
    RenderOptions options = level_options();
    options.initial = Initial::emission;
    options.tolerance = 1e-4;
    for (const float albedo : {0.5F, 0.8F}) {
        const RenderResult result = render_layers(furnace(albedo), options);
        expect_uniform(layer(result, ""), 1.0 / (1.0 - static_cast<double>(albedo)), promised);
        EXPECT_TRUE(result.stats.tail_closed);
    }
}

TEST(Levels, BouncesAreCountedExactly) {
    for (int bounces = 0; bounces <= 6; ++bounces) {
        RenderOptions options = level_options();
        options.initial = Initial::emission;
        options.bounces = bounces;
        SCOPED_TRACE(bounces);
        expect_uniform(layer(render_layers(furnace(0.5F), options), ""), 2.0 * (1.0 - std::pow(0.5, bounces + 1)), promised);
    }
}

TEST(Levels, CarryTheLightOfSets) {
    RenderOptions options = level_options();
    options.width = options.height = 24;
    options.method = MethodName::hybrid;
    const double levels = mean_rgb(layer(render_layers(lit_wall_box(), options), "").pixels).x;
    options.iterate = Iterate::sets;
    const double sets = mean_rgb(layer(render_layers(lit_wall_box(), options), "").pixels).x;
    EXPECT_NEAR(levels / sets, 1.0, 0.015);
}

TEST(Levels, CarryLimitedOrdersOfBothKindsOfEmitters) {
    RenderOptions options = level_options();
    options.width = options.height = 24;
    Scene scene = lit_wall_box();
    scene.point_lights.push_back({{0.3, 0.4, 0.6}, glm::vec3(0.2F)});
    for (const int bounces : {2, 3, 4}) {
        options.bounces = bounces;
        options.iterate = Iterate::levels;
        const double levels = mean_rgb(layer(render_layers(scene, options), "").pixels).x;
        options.iterate = Iterate::sets;
        const double sets = mean_rgb(layer(render_layers(scene, options), "").pixels).x;
        EXPECT_NEAR(levels / sets, 1.0, 0.04) << bounces << ": other pencils; an order more or less is 0.1 and more";
    }
}

}  // namespace
}  // namespace pencil::test
