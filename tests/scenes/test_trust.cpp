// Rooms on which renderers that reuse light go wrong (scenes/trust): the surface method against the path tracer, mean and claimed error.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "reference/path_tracer.h"
#include "render/render_session.h"
#include "scene/formats/load_scene.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

struct Hard {
    const char* name;
    std::vector<std::pair<std::string, std::string>> defines;
    double target;     // --target-error
    double tolerance;  // of the mean, beside the noise of both
};

void PrintTo(const Hard& hard, std::ostream* out) { *out << hard.name; }

Scene load(const Hard& hard) {
    LoadOptions options;
    options.defines = {hard.defines.begin(), hard.defines.end()};
    options.defines["width"] = "48";
    options.defines["height"] = "36";
    return load_scene(std::filesystem::path(PENCIL_SOURCE_DIR) / "scenes" / "trust" / (std::string(hard.name) + ".xml"), options);
}

double mean(const std::vector<float>& pixels) {
    return std::accumulate(pixels.begin(), pixels.end(), 0.0) / static_cast<double>(pixels.size());
}

class Trust : public testing::TestWithParam<Hard> {};

/// Of the path tracer's image, from two seeds.
struct Truth {
    double mean = 0, noise = 0;
};
Truth truth_of(const Scene& scene, int spp = 256) {
    ReferenceOptions reference;
    reference.spp = spp;
    Truth truth;
    for (std::uint64_t seed : {1, 2}) {
        reference.seed = seed;
        const double m = mean(trace_paths(scene, reference).layers.front().pixels);
        truth.noise += (seed == 1 ? m : -m) / 2;
        truth.mean += m / 2;
    }
    truth.noise = std::abs(truth.noise);
    return truth;
}

TEST_P(Trust, MeanIsThePathTracers) {
    const Scene scene = load(GetParam());
    const auto [expected, noise] = truth_of(scene);
    RenderOptions options;
    options.target_error = GetParam().target;
    const RenderResult result = render_layers(scene, options);
    EXPECT_NEAR(mean(layer(result, "").pixels) / expected, 1.0, GetParam().tolerance + 3.0 * noise / expected);
    EXPECT_TRUE(std::isfinite(result.stats.estimated_error));
    EXPECT_LT(result.stats.passes, 400) << "there is an end";
}

INSTANTIATE_TEST_SUITE_P(Scenes, Trust,
                         testing::Values(Hard{"outdoor-rooms", {}, 4e-3, 0.06}, Hard{"tunnel", {}, 2e-3, 0.03},
                                         Hard{"ground-plane", {{"extent", "1e6"}}, 5e-3, 0.03},
                                         Hard{"far-light", {{"distance", "1e4"}, {"size", "2.5e3"}}, 1e-2, 0.05},
                                         Hard{"uplight", {}, 1e-2, 0.02}, Hard{"wall-lamps", {}, 1e-3, 0.02},
                                         Hard{"bright-room", {{"albedo", "0.97"}}, 1e-2, 0.025}, Hard{"contacts", {}, 1e-2, 0.02},
                                         Hard{"coincident", {}, 1e-2, 0.02}));

/// Where few directions find the light, film pencils send rays of their own to it, and only there.
TEST(TrustSpots, AreFoundWhereLightIsHidden) {
    const auto spots = [](const char* name) {
        RenderOptions options;
        options.target_error = 1;
        const RenderResult result = render_layers(load({name, {}, 0, 0}), options);
        return std::any_of(result.stats.explain.begin(), result.stats.explain.end(),
                           [](const std::string& line) { return line.find("bright spots: pencils send") == 0; });
    };
    EXPECT_TRUE(spots("uplight"));
    EXPECT_TRUE(spots("tunnel")) << "comes in at the ends";
    EXPECT_TRUE(spots("cove")) << "comes from a strip of the ceiling";
    EXPECT_TRUE(spots("wall-lamps"));
    EXPECT_FALSE(spots("contacts"));
    EXPECT_FALSE(spots("bright-room"));
}

/// Rays to spots and portals take noise, not light: passes of many seeds have the mean of one long render: the first, whose world set finds its
/// spots, and the first four. And that has the path tracer's.
class TrustHidden : public testing::TestWithParam<const char*> {};
TEST_P(TrustHidden, RaysToItTakeNoLight) {
    const Scene scene = load({GetParam(), {}, 0, 0});
    RenderOptions options;
    options.target_error = 1e-3;
    const double expected = mean(layer(render_layers(scene, options), "").pixels);
    const auto [truth, noise] = truth_of(scene);
    EXPECT_NEAR(expected / truth, 1.0, 0.02 + 3.0 * noise / truth);
    constexpr int seeds = 12;
    double first = 0, fourth = 0;
    options.aovs = {};
    for (options.seed = 1; options.seed <= seeds; ++options.seed) {
        RenderSession session(scene, options, device());
        session.advance();
        first += mean(session.snapshot().front().pixels) / seeds;
        for (int pass = 1; pass < 4; ++pass) session.advance();
        fourth += mean(session.snapshot().front().pixels) / seeds;
    }
    EXPECT_NEAR(first / expected, 1.0, 0.05);
    EXPECT_NEAR(fourth / expected, 1.0, 0.02);
}
INSTANTIATE_TEST_SUITE_P(Scenes, TrustHidden, testing::Values("uplight", "tunnel"),
                         [](const auto& tested) { return std::string(tested.param); });

/// What a lamp lights on the ceiling just above it is known from the first pass on, whatever the seed: without rays of their own to it means of
/// passes vary by a seventh.
TEST(TrustSpots, ALampUnderTheCeilingLooksForWhatItLights) {
    const Scene scene = room_with_near_lamp(0.005);
    RenderOptions options;
    options.target_error = 1e-9;
    options.aovs = {"bounces"};
    constexpr int seeds = 10;
    double sum = 0, squares = 0;
    for (options.seed = 1; options.seed <= seeds; ++options.seed) {
        RenderSession session(scene, options, device());
        session.advance();
        const double m = mean(layer(session.snapshot(), "indirect").pixels);
        sum += m;
        squares += m * m;
    }
    const double average = sum / seeds, deviation = std::sqrt(squares / seeds - average * average) / average;
    std::printf("first passes vary by %.1f %%\n", 100 * deviation);
    EXPECT_LT(deviation, 0.05);
}

/// What a lamp lights on the ceiling just above it, nearer than a pixel is wide: light samples carry part of it, film pencils the rest.
TEST(TrustSpots, ALampNearerThanAPixelLightsAllThatItLights) {
    const Scene scene = room_with_near_lamp(0.005);
    ReferenceOptions reference;
    reference.spp = 1 << 12;
    reference.bounces = true;
    const auto brightest = [](const std::vector<float>& image) { return *std::max_element(image.begin(), image.end()); };
    const double expected = brightest(layer(trace_paths(scene, reference).layers, "direct").pixels);
    RenderOptions options;
    options.bounces = 1;
    options.target_error = 1e-9;
    options.aovs = {"direct", "bounces"};
    RenderSession session(scene, options, device());
    for (int pass = 0; pass < 30; ++pass) session.advance();
    std::vector<float> light = layer(session.snapshot(), "direct").pixels;
    const std::vector<float> near = layer(session.snapshot(), "indirect").pixels;
    for (std::size_t i = 0; i < light.size(); ++i) light[i] += near[i];
    std::printf("brightest pixel %.4f of the path tracer's\n", brightest(light) / expected);
    EXPECT_NEAR(brightest(light) / expected, 1.0, 0.03);
}

/// A lamp of half a pixel is as bright as it is, and known soon: sixteen visibility samples a pass meet it eight times, give or take one.
TEST(TrustSpots, ALampSmallerThanAPixelHasItsLight) {
    Scene scene = room_with_near_lamp(0.9);
    look_at(scene, {0.3, 0.6, 0.3}, {2.625, 2.075, 2.325}, {0, 1, 0}, 70.0, 32, 24);
    ReferenceOptions reference;
    reference.spp = 1 << 12;
    reference.bounces = true;
    const double expected = mean(layer(trace_paths(scene, reference).layers, "emission").pixels);
    RenderOptions options;
    options.aovs = {"emission"};
    const RenderResult result = render_layers(scene, options, {"emission"});
    EXPECT_NEAR(mean(layer(result, "emission").pixels) / expected, 1.0, 0.02);
    std::printf("%d passes\n", result.stats.passes);
    EXPECT_LT(result.stats.passes, 64);
}

bool begins_elsewhere_too(const RenderStats& stats) {
    return std::any_of(
        stats.explain.begin(), stats.explain.end(),
        [](const std::string& line) { return line.find("first seeds missed") != std::string::npos; });
}

/// Seeds fall on the first room alone.
TEST(TrustSeeds, ARoomThatFewPixelsShowIsLitAsOthers) {
    RenderOptions options;
    options.target_error = 1;
    const RenderResult result = render_layers(two_furnaces(), options);
    const Layer image = layer(result, "");
    for (std::size_t y = 0; y < 36; ++y) {
        EXPECT_NEAR(pixel(image, 48 * y + 20).x, 0.02, 0.001);
        for (std::size_t x = 44; x < 48; ++x) EXPECT_NEAR(pixel(image, 48 * y + x).x, 1.0, 0.06) << x << ", " << y;
    }
    EXPECT_TRUE(begins_elsewhere_too(result.stats));
    EXPECT_FALSE(begins_elsewhere_too(render_layers(furnace(0.5F), options).stats));
}

/// Nothing that seeds see reflects: two small plates on black ground under a sky face each other, between them.
TEST(TrustSeeds, WhatIsSmallUnderASkyIsFound) {
    Scene scene;
    const Surface black{glm::vec3(0.0F)}, white{glm::vec3(0.8F)};
    add_quad(scene, "ground", {-1e4, 0, 1e4}, {2e4, 0, 0}, {0, 0, -2e4}, black);
    add_quad(scene, "plate", {0.04, 0, 0.1}, {0, 0, -0.2}, {0, 0.1, 0}, white);
    add_quad(scene, "other", {0.1, 0, -0.1}, {0, 0, 0.2}, {0, 0.1, 0}, white);
    Environment sky;
    sky.width = sky.height = 1;
    sky.texels.assign(1, glm::vec3(1.0F));
    scene.environment = sky;
    look_at(scene, {-0.4, 1.5, 0}, {0, 0, 0}, {0, 0, -1}, 60, 48, 36);
    const double truth = truth_of(scene, 1 << 13).mean;  // known to 0.2 %
    RenderOptions options;
    options.seconds = 2;
    const double ratio = mean(layer(render_layers(scene, options), "").pixels) / truth;
    std::printf("mean %.4f of the path tracer's\n", ratio);
    EXPECT_NEAR(ratio, 1.0, 0.015);
}

/// The image hardly depends on how far the ground goes on.
TEST(TrustScale, GroundPlanesOfAllSizes) {
    RenderOptions options;
    options.target_error = 4e-3;
    std::vector<double> means;
    for (const char* extent : {"1e2", "1e4", "1e6"}) {
        const Scene scene = load({"ground-plane", {{"extent", extent}}, 0, 0});
        means.push_back(mean(layer(render_layers(scene, options), "").pixels));
    }
    EXPECT_NEAR(means[1] / means[0], 1.0, 0.03);
    EXPECT_NEAR(means[2] / means[0], 1.0, 0.03);
}

}  // namespace
