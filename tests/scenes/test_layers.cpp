// Layers of surfaces at silhouettes, what a stopped session leaves, and a series without a sum.
#include <algorithm>
#include <cmath>

#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace pencil::test {
namespace {

/// A square in the plane z = 3 that fills the middle of the view, with nothing behind it.
Scene square_before_nothing() {
    Scene scene;
    add_quad(scene, "square", {-0.5, -0.5, 3}, {0, 1, 0}, {1, 0, 0}, {glm::vec3(0.5F), glm::vec3(1.0F), false});
    scene.sensor.width = scene.sensor.height = 33;
    scene.sensor.fov_x = 30;
    return scene;
}

TEST(Silhouettes, PositionAndDepthAreThoseOfTheCoveredPart) {
    RenderOptions options;
    options.target_error = 1;
    const RenderResult result = render_layers(square_before_nothing(), options, {"position", "depth", "normal"});
    const Layer &position = layer(result, "position"), &depth = layer(result, "depth"), &normal = layer(result, "normal");
    int rim = 0, inside = 0;
    for (std::size_t i = 0; i < depth.pixels.size(); ++i) {
        const float* p = &position.pixels[3 * i];
        const double length = std::sqrt(static_cast<double>(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
        const double cover = std::abs(normal.pixels[3 * i + 2]);
        if (length == 0) continue;
        EXPECT_NEAR(p[2], 3.0, 1e-4) << "pixel " << i << ", covered " << cover;
        EXPECT_NEAR(depth.pixels[i], length, 1e-4) << "pixel " << i;
        EXPECT_LE(std::max(std::abs(p[0]), std::abs(p[1])), 0.5001) << "pixel " << i;
        ++(cover < 0.99 ? rim : inside);
    }
    EXPECT_GT(rim, 40) << "there is a rim to judge";
    EXPECT_GT(inside, 100);
}

TEST(PrintedWeights, SeriesWithoutASumIsNamedAndFinite) {
    Scene scene = furnace(0.9F);
    RenderOptions options = line_options();
    options.weights = Weights::thesis;
    options.pencils = 64;
    options.width = options.height = 16;
    const RenderResult result = render_layers(scene, options);
    const auto& warnings = result.stats.warnings;
    EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& w) {
        return w.find("series has no sum") != std::string::npos;
    })) << "no warning";
    EXPECT_FALSE(std::isfinite(result.stats.residual));
    for (const float value : layer(result, "").pixels) ASSERT_TRUE(std::isfinite(value) && value < 1e6F) << value;
}

}  // namespace
}  // namespace pencil::test
