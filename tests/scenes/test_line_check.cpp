// Light paths check the images of lines, which know nothing of their own error.
#include <algorithm>
#include <cmath>

#include "reference/path_tracer.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

bool said_to_be_wrong(const RenderStats& stats) {
    return std::any_of(
        stats.warnings.begin(), stats.warnings.end(),
        [](const std::string& w) { return w.find("find the image's mean wrong") != std::string::npos; });
}

double mean(const Layer& image) {
    double sum = 0;
    for (const float v : image.pixels) sum += static_cast<double>(v);
    return sum / static_cast<double>(image.pixels.size());
}

RenderOptions few_pencils(MethodName method) {
    RenderOptions options;
    options.method = method;
    options.pencils = 16;
    options.map = 32;
    options.width = options.height = 32;
    return options;
}

class LineCheck : public testing::TestWithParam<MethodName> {};

/// All see the same light: lines are right, and nothing is said.
TEST_P(LineCheck, FindsNothingInAFurnace) {
    const RenderResult result = render_layers(furnace(0.5F), few_pencils(GetParam()));
    EXPECT_GE(result.stats.certified.points, 2);
    EXPECT_NEAR(result.stats.certified.mean_bias, 0.0, 0.01);
    EXPECT_LT(result.stats.estimated_error, 1e-4);
    EXPECT_FALSE(said_to_be_wrong(result.stats));
}

/// What it says of the mean is true, and what is wrong is not wrong in silence. Emission is no matter of lines.
TEST_P(LineCheck, KnowsHowWrongTheMeanIs) {
    Scene scene = room_with_near_lamp(0.3);
    scene.sensor.width = scene.sensor.height = 32;
    ReferenceOptions reference;
    reference.spp = 1024;
    reference.bounces = true;
    const std::vector<Layer> paths = trace_paths(scene, reference).layers;
    const RenderResult result = render_layers(scene, few_pencils(GetParam()), {"emission"});
    const double truth = mean(paths.front()) - mean(layer(paths, "emission")), shown = mean(layer(result, "")),
                 bias = (shown - mean(layer(result, "emission")) - truth) / shown;
    const CertifiedError& found = result.stats.certified;
    std::printf("the mean is off by %.3f, found %.3f +- %.3f\n", bias, found.mean_bias, found.mean_error);
    EXPECT_NEAR(found.mean_bias, bias, 4 * found.mean_error + 0.01);
    EXPECT_LT(found.mean_error, 0.03);
    const bool is_wrong = std::abs(bias) > 0.1;
    EXPECT_EQ(is_wrong, GetParam() == MethodName::line) << "so few pencils show too little";
    EXPECT_EQ(said_to_be_wrong(result.stats), is_wrong);
}

INSTANTIATE_TEST_SUITE_P(Methods, LineCheck, testing::Values(MethodName::line, MethodName::hybrid),
                         [](const auto& tested) { return std::string(tested.param == MethodName::line ? "line" : "hybrid"); });

bool left_out(const RenderStats& stats) {
    return std::any_of(
        stats.explain.begin(), stats.explain.end(),
        [](const std::string& line) { return line.find("left out: check by light paths") == 0; });
}

/// Paths are cut where light lives too long, however the series is made; where bounces are few they are short.
TEST(LineCheckOptions, LightThatLivesTooLongIsNotChecked) {
    for (const Iterate iterate : {Iterate::sets, Iterate::levels}) {
        RenderOptions options = few_pencils(MethodName::line);
        options.iterate = iterate;
        const RenderResult endless = render_layers(furnace(0.9999F), options);
        EXPECT_TRUE(left_out(endless.stats));
        EXPECT_FALSE(said_to_be_wrong(endless.stats));
        EXPECT_EQ(endless.stats.certified.points, 0);
        options.bounces = 3;
        const RenderResult few = render_layers(furnace(0.9999F), options);
        EXPECT_FALSE(left_out(few.stats));
        EXPECT_GE(few.stats.certified.points, 2);
        EXPECT_NEAR(few.stats.certified.mean_bias, 0.0, 0.01);
    }
}

TEST(LineCheckOptions, ViewsOfFieldsAndEmissionAloneAreNotChecked) {
    RenderOptions options = few_pencils(MethodName::line);
    options.bounces = 0;
    EXPECT_EQ(render_layers(furnace(0.5F), options).stats.certified.points, 0);
    options.bounces = -1;
    options.keep_field = true;
    const RenderResult baked = render_layers(furnace(0.5F), options);
    EXPECT_EQ(baked.stats.certified.points, 0);
    RenderOptions view;
    view.method = MethodName::line;
    view.field = baked.field;
    EXPECT_EQ(render_layers(furnace(0.5F), view).stats.certified.points, 0);
}

}  // namespace
