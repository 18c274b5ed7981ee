// A session a step at a time: what a client sees between the steps, and what is left when it stops.
#include <algorithm>
#include <cmath>
#include <functional>

#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/error.h"

namespace pencil::test {
namespace {

RenderOptions small_options(MethodName method) {
    RenderOptions options;
    options.method = method;
    options.pencils = 24;
    options.map = 16;
    options.light_samples = 8;
    options.width = options.height = 24;
    options.target_error = 1e-6;
    options.tolerance = 0.05;
    return options;
}

bool same(const std::vector<Layer>& a, const std::vector<Layer>& b) {
    return std::equal(
        a.begin(), a.end(), b.begin(), b.end(), [](const Layer& x, const Layer& y) { return x.name == y.name && x.pixels == y.pixels; });
}

bool has(const std::vector<Layer>& layers, const std::string& name) {
    return std::any_of(
        layers.begin(), layers.end(), [&](const Layer& layer) { return layer.name == name; });
}

class Session : public testing::TestWithParam<MethodName> {};

TEST_P(Session, LoopIsRenderAndSnapshotsDoNotDisturb) {
    const Scene scene = cie_cube(0.5);
    const RenderOptions options = small_options(GetParam());
    RenderSession session(scene, options, device());
    EXPECT_TRUE(session.snapshot().empty()) << "before the first step";
    int steps = 1;
    for (; steps < 7 && session.advance(); ++steps) EXPECT_FALSE(session.snapshot().empty());
    while (session.advance()) ++steps;
    const std::vector<Layer> last = session.snapshot();
    const RenderResult result = session.finish();
    EXPECT_TRUE(same(last, result.layers));
    EXPECT_TRUE(same(last, render(scene, options, device()).layers));
    EXPECT_GE(steps, 3);
}

TEST_P(Session, StopsBetweenLaunchesWithAnImage) {
    const Scene scene = cie_cube(0.5);
    int calls = 0;
    const RenderResult whole = render(scene, small_options(GetParam()), device(), [&](const std::string&, double) { return ++calls > 0; });
    EXPECT_FALSE(whole.interrupted);
    EXPECT_GT(calls, 60) << "more often than there are stages";
    for (const int stop : {1, calls / 8, calls / 4, calls / 2, calls - 1}) {
        int now = 0;
        const RenderResult result =
            render(scene, small_options(GetParam()), device(), [&](const std::string&, double) { return ++now < stop; });
        EXPECT_TRUE(result.interrupted) << "stop at " << stop;
        ASSERT_FALSE(result.layers.empty()) << "stop at " << stop;
        EXPECT_EQ(result.layers.front().name, "");
        EXPECT_EQ(result.layers.front().pixels.size(), 24U * 24U * 3U);
        for (const float value : result.layers.front().pixels) ASSERT_TRUE(std::isfinite(value)) << "stop at " << stop;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, Session, testing::Values(MethodName::surface, MethodName::line),
                         [](const auto& method) { return method.param == MethodName::line ? "line" : "surface"; });

/// One pass has no spread: light paths alone tell its error.
TEST(SessionOfPasses, ErrorIsKnownFromTheFirstAndFalls) {
    const Scene scene = cie_cube(0.5);
    RenderSession session(scene, small_options(MethodName::surface), device());
    ASSERT_TRUE(session.advance());
    EXPECT_TRUE(std::isfinite(session.estimated_error()));
    EXPECT_GT(session.stats().certified.points, 0);
    EXPECT_FALSE(has(session.snapshot(), error_layer));
    ASSERT_TRUE(session.advance());
    const double second = session.estimated_error();
    EXPECT_TRUE(std::isfinite(second));
    EXPECT_TRUE(has(session.snapshot(), error_layer));
    for (int k = 0; k < 20; ++k) session.advance();
    EXPECT_LT(session.estimated_error(), second);
    EXPECT_EQ(session.stats().passes, 22);
}

TEST(SessionOfBounces, EachStepAddsOne) {
    const Scene scene = cie_cube(0.5);
    RenderSession session(scene, small_options(MethodName::line), device());
    ASSERT_TRUE(session.advance());
    EXPECT_TRUE(has(session.snapshot(), "direct"));
    EXPECT_FALSE(has(session.snapshot(), "bounce2"));
    ASSERT_TRUE(session.advance());
    EXPECT_TRUE(has(session.snapshot(), "bounce2"));
    EXPECT_FALSE(has(session.snapshot(), "bounce3"));
}

TEST(SessionOfPasses, NothingFollowsTheEnd) {
    const Scene scene = cie_cube(0.5);
    RenderSession session(scene, small_options(MethodName::surface), device());
    for (int k = 0; k < 3; ++k) ASSERT_TRUE(session.advance());
    EXPECT_FALSE(session.finish().layers.empty());
    EXPECT_FALSE(session.advance());
    EXPECT_TRUE(session.snapshot().empty());
    EXPECT_FALSE(std::isfinite(session.estimated_error()));
}

TEST(SessionOptions, AreCheckedByTheTable) {
    const Scene scene = furnace(0.5F);
    const auto refused = [&](const std::function<void(RenderOptions&)>& change, const std::string& reason) {
        RenderOptions options = small_options(MethodName::line);
        change(options);
        try {
            RenderSession session(scene, options, device());
            ADD_FAILURE() << reason << " was not refused";
        } catch (const UsageError& error) {
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
    };
    refused([](RenderOptions& o) { o.map = 12; }, "--map: \"12\" is not a multiple of 8");
    refused([](RenderOptions& o) { o.film_samples = 65; }, "--film-samples");
    refused([](RenderOptions& o) { o.light_samples = 0; }, "--light-samples");
    refused([](RenderOptions& o) { o.pencils = -1; }, "--pencils");
    refused([](RenderOptions& o) { o.decay = std::nan(""); }, "--decay");
    refused([](RenderOptions& o) { o.tolerance = 0; }, "--tolerance");
    refused([](RenderOptions& o) { o.placement.clear(); }, "--placement");
    refused([](RenderOptions& o) { o.aovs = {"colour"}; }, "--aov");
}

TEST(SessionOptions, AreSettledByMethodAndScene) {
    Scene scene = furnace(0.5F);
    scene.max_depth = 3;
    scene.sensor.width = 40;
    scene.sensor.height = 30;
    RenderOptions options;
    EXPECT_EQ(resolve(options, scene).pencils, standard_pencils(MethodName::surface));
    EXPECT_EQ(resolve(options, scene).bounces, 2);
    EXPECT_EQ(resolve(options, scene).width, 40);
    options.method = MethodName::line;
    options.bounces = endless_bounces;
    options.width = options.height = 8;
    EXPECT_EQ(resolve(options, scene).pencils, standard_pencils(MethodName::line));
    EXPECT_EQ(resolve(options, scene).least_pencils, standard_least_pencils(MethodName::line));
    EXPECT_EQ(resolve(options, scene).bounces, endless_bounces);
    EXPECT_EQ(resolve(options, scene).height, 8);
}

}  // namespace
}  // namespace pencil::test
