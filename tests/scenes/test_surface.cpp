// The surface method against closed-form answers: what the line projection loses near walls, closed rooms, bounces one by one, and an
// error that falls with time and is known without a reference.
#include <cmath>
#include <limits>

#include "reference/form_factor_ref.h"
#include "reference/path_tracer.h"
#include "scene/formats/load_scene.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

RenderOptions surface_options(Initial initial) {
    RenderOptions options;
    options.method = MethodName::surface;
    options.initial = initial;
    options.pencils = 300;
    options.film_samples = 4;
    options.target_error = 1e6;  // as few passes as may be
    return options;
}

double mean(const Layer& image) {
    double sum = 0.0;
    for (const float value : image.pixels) sum += value;
    return sum / static_cast<double>(image.pixels.size());
}

TEST(Surface, FurnaceIsTheWholeSeries) {
    for (const float albedo : {0.5F, 0.8F}) {
        RenderOptions options = surface_options(Initial::emission);
        options.tolerance = 1e-4;
        SCOPED_TRACE(albedo);
        expect_uniform(layer(render_layers(furnace(albedo), options), ""), 1.0 / (1.0 - static_cast<double>(albedo)), 1e-3);
    }
}

TEST(Surface, TheSeriesIsClosedByItsTail) {
    // Steps fall by 1 % only: cut at the default tolerance the series would lose 1 % of the light.
    expect_uniform(layer(render_layers(furnace(0.99F), surface_options(Initial::emission)), ""), 100.0, 1e-3);
}

TEST(Surface, OneTriangleAndNone) {
    Scene scene;
    scene.point_lights.push_back({{0, 0, 0}, glm::vec3(3.0F)});
    look_at(scene, {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 1.0, 1, 1);
    EXPECT_EQ(layer(render_layers(scene, surface_options(Initial::automatic)), "").pixels[0], 0.0F);
    add_shape(scene, "triangle", {{dvec3(-1, -1, 1), dvec3(0, 2, 1), dvec3(1, -1, 1)}}, {glm::vec3(0.8F), glm::vec3(0.0F), false});
    EXPECT_NEAR(layer(render_layers(scene, surface_options(Initial::automatic)), "").pixels[0], 0.8 / 3.14159265 * 3.0, 1e-3);
}

TEST(Surface, BouncesCountAsTheSceneAsks) {
    const double a = 0.8F;
    for (int bounces = 0; bounces <= 4; ++bounces) {
        RenderOptions options = surface_options(Initial::emission);
        options.bounces = bounces;
        SCOPED_TRACE(bounces);
        expect_uniform(layer(render_layers(furnace(0.8F), options), ""), (1.0 - std::pow(a, bounces + 1)) / (1.0 - a), 1e-3);
    }
}

TEST(Surface, SampledLightsBounceAsOften) {
    // The same room lit by light samples or by emission in the maps: each order must agree, or one of them is counted wrongly.
    Scene scene = two_rooms(0.1, true);
    look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 64, 64);
    for (int bounces = 1; bounces <= 3; ++bounces) {
        double means[2];
        for (const Initial initial : {Initial::direct, Initial::emission}) {
            RenderOptions options = surface_options(initial);
            options.bounces = bounces;
            options.light_samples = 512;
            means[initial == Initial::emission ? 1 : 0] = mean(layer(render_layers(scene, options), ""));
        }
        EXPECT_NEAR(means[1] / means[0], 1.0, 0.03) << bounces << " bounces";
    }
}

class SurfaceLitWall : public testing::TestWithParam<Initial> {};

/// `direct`: light samples and what the pencils see near the emitter add up to all of its light, down to the corner.
TEST_P(SurfaceLitWall, UpToTheCorner) {
    RenderOptions options = surface_options(GetParam());
    options.bounces = 1;
    options.target_error = 1e-4;
    const RenderResult result = render_layers(lit_wall_box(), options, {"position"});
    const Layer &light = layer(result, ""), &position = layer(result, "position");
    for (const auto& [x, z] : {std::pair{0.5, 0.5}, {0.2, 0.5}, {0.05, 0.5}, {0.01, 0.5}, {0.02, 0.02}}) {
        std::size_t best = 0;
        double nearest = 1e9;
        for (std::size_t i = 0; i < pixel_count(position); ++i) {
            const double d = glm::distance(pixel(position, i), dvec3(x, 0.0, z));
            if (d < nearest) {
                nearest = d;
                best = i;
            }
        }
        const dvec3 at = pixel(position, best);
        const double ratio = pixel(light, best).x * ref::pi / ref::lit_wall_irradiance(at.x, at.z);
        std::printf("lit wall, surface method, at %.2f %.2f: %.4f of the exact irradiance\n", x, z, ratio);
        EXPECT_NEAR(ratio, 1.0, 0.05) << x << " " << z;
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, SurfaceLitWall, testing::Values(Initial::emission, Initial::direct));

TEST(Surface, NoLightThroughWalls) {
    for (const double thickness : {0.0, 0.01, 0.1}) {
        Scene scene = two_rooms(thickness, false);
        const double dark = mean(layer(render_layers(scene, surface_options(Initial::direct)), ""));
        look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 64, 64);
        const double lit = mean(layer(render_layers(scene, surface_options(Initial::direct)), ""));
        std::printf("leak of the surface method through a wall of %g: %.2e\n", thickness, dark / lit);
        EXPECT_LT(dark / lit, 1e-3) << thickness;
    }
}

/// Mean radiance of columns 0 .. size / 2 of the lower half, by channel.
dvec3 mean_of_quarter(const Layer& image, int size) {
    dvec3 sum(0);
    for (int y = size / 2; y < size; ++y)
        for (int x = 0; x < size / 2; ++x)
            for (int c = 0; c < 3; ++c) {
                const int value = (y * size + x) * 3 + c;
                sum[c] += static_cast<double>(image.pixels[static_cast<std::size_t>(value)]);
            }
    return sum / (0.25 * size * size);
}

/// A furnished room of light walls, where light is lost or gained at every bounce if world pencils near contacts count too much or too
/// little: the lit room of thin walls, lower left.
TEST(Surface, BouncesKeepTheLight) {
    const Scene scene = load_scene(std::filesystem::path(PENCIL_SOURCE_DIR) / "scenes" / "thin-walls.xml");
    constexpr int size = 48;
    ReferenceOptions reference;
    reference.spp = 1024;
    reference.width = reference.height = size;
    const dvec3 truth = mean_of_quarter(trace_paths(scene, reference).layers.front(), size);
    RenderOptions options;
    options.method = MethodName::surface;
    options.pencils = 800;
    options.width = options.height = size;
    options.target_error = 1e-3;
    const dvec3 ratio = mean_of_quarter(layer(render_layers(scene, options), ""), size) / truth;
    std::printf("surface method over path tracer: %.4f %.4f %.4f\n", ratio.x, ratio.y, ratio.z);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 0.007) << "channel " << c;
}

TEST(Surface, TwoRendersAreBitwiseEqual) {
    Scene scene = two_rooms(0.1, true);
    look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 48, 48);
    for (const double target : {1e6, 1e-4}) {
        RenderOptions options = surface_options(Initial::direct);
        options.target_error = target;
        const RenderResult first = render_layers(scene, options);
        EXPECT_EQ(layer(first, "").pixels, layer(render_layers(scene, options), "").pixels);
        EXPECT_GE(first.stats.passes, target < 1.0 ? 15 : 1) << "world sets that are shared, sequences that go on, fine film pencils";
    }
}

TEST(Surface, FurnaceIsExactInEveryGeneration) {
    RenderOptions options = surface_options(Initial::emission);
    options.target_error = std::numeric_limits<double>::min();  // never reached: the passes are counted
    options.width = options.height = 16;
    const Scene scene = furnace(0.8F);
    RenderSession session(scene, options, device());
    for (int pass = 0; pass < 15; ++pass) ASSERT_TRUE(session.advance());
    const RenderResult result = session.finish();
    EXPECT_EQ(result.stats.passes, 15) << "one of the fourth generation, which has fine film pencils";
    expect_uniform(layer(result, ""), 5.0, 1e-3);
}

/// A floor and a wall that fill a few pixels, none of which lies on the lattice of seeds.
TEST(Surface, SmallThingsAreSeeds) {
    Scene scene;
    scene.point_lights.push_back({{0.5F, 0.5F, 0.5F}, glm::vec3(3.0F)});
    const Surface white{glm::vec3(0.8F), glm::vec3(0.0F), true};
    add_shape(scene, "floor", {{dvec3(0, 0, 0), dvec3(0, 0, 1), dvec3(1, 0, 1)}, {dvec3(0, 0, 0), dvec3(1, 0, 1), dvec3(1, 0, 0)}}, white);
    add_shape(scene, "wall", {{dvec3(0, 0, 0), dvec3(0, 1, 0), dvec3(0, 1, 1)}, {dvec3(0, 0, 0), dvec3(0, 1, 1), dvec3(0, 0, 1)}}, white);
    look_at(scene, {4.5, 4, 0.5}, {0.25, 0.25, 0.5}, {0, 1, 0}, 60.0, 24, 24);
    const RenderResult result = render_layers(scene, surface_options(Initial::direct), {"direct", "bounces"});
    EXPECT_GT(result.stats.world_pencils, 0U);
    EXPECT_GT(mean(layer(result, "indirect")), 0.05 * mean(layer(result, "direct")));
}

TEST(Surface, MoreTimeLowersTheErrorAndTheErrorIsKnown) {
    Scene scene = two_rooms(0.1, true);
    look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 64, 64);
    RenderOptions options = surface_options(Initial::direct);
    options.target_error = 5e-5;
    options.seed = 7;
    const RenderResult fine = render_layers(scene, options);
    const std::vector<float>& truth = layer(fine, "").pixels;
    const double level = mean(layer(fine, ""));
    double last = 1e9;
    for (const double target : {1e-2, 5e-4}) {
        options.seed = 1;
        options.target_error = target;
        const RenderResult result = render_layers(scene, options);
        double error = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const double r = truth[i], d = layer(result, "").pixels[i] - r;
            error += d * d / (r * r + 0.01 * level * level) / static_cast<double>(truth.size());
        }
        std::printf("target %.0e: %d passes, estimated %.2e, true %.2e\n", target, result.stats.passes, result.stats.estimated_error,
                    error);
        EXPECT_LE(error, last);
        if (target < 1e-3) {  // the truth itself has relMSE of about 5e-5
            const double ratio = std::sqrt(std::max(error - 5e-5, 0.0) / result.stats.estimated_error);
            EXPECT_GT(ratio, 1.0 / 2.0);  // to claim too much is the smaller fault
            EXPECT_LT(ratio, 1.5);
        }
        last = error;
    }
}

}  // namespace
