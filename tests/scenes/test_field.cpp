// Fields of pencils: light made by one method, shown by another, and the same light whoever made it.
#include "reference/path_tracer.h"
#include "render/render_session.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/error.h"

namespace pencil::test {
namespace {

/// A lit room whose walls differ in colour, so that no mirrored map would pass.
Scene coloured_room() {
    Scene scene;
    const glm::vec3 colours[6] = {{0.8F, 0.1F, 0.1F}, {0.1F, 0.8F, 0.1F}, {0.2F, 0.2F, 0.8F},
                                  {0.7F, 0.7F, 0.2F}, {0.2F, 0.7F, 0.7F}, {0.6F, 0.3F, 0.6F}};
    for (int wall = 0; wall < 6; ++wall) add_wall(scene, wall, {0, 0, 0}, {1, 1, 1}, {colours[wall], glm::vec3(0.0F), false});
    scene.point_lights.push_back({{0.3, 0.8, 0.6}, glm::vec3(1.0F)});
    look_at(scene, {0.9, 0.5, 0.1}, {0.1, 0.4, 0.9}, {0, 1, 0}, 70.0, 32, 32);
    return scene;
}

RenderOptions field_options() {
    RenderOptions options = line_options();
    options.method = MethodName::hybrid;
    options.iterate = Iterate::fixed;
    options.pencils = 24;
    options.map = 16;
    options.width = options.height = 32;
    options.aovs = {};
    options.keep_field = true;
    return options;
}

dvec3 mean_of_all(const std::vector<float>& rgb) {
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < rgb.size(); ++i) sum[static_cast<int>(i % 3)] += rgb[i] * 3.0 / static_cast<double>(rgb.size());
    return sum;
}

TEST(Field, ShowsTheLightOfTheSetThatItWasMadeFrom) {
    const Scene scene = coloured_room();
    const RenderResult made = render(scene, field_options(), device());
    ASSERT_TRUE(made.field);
    EXPECT_EQ(made.field->count(), 24);
    RenderOptions options = field_options();
    options.keep_field = false;
    options.field = made.field;
    const RenderResult shown = render(scene, options, device());
    EXPECT_FALSE(shown.field);
    const dvec3 ratio = mean_of_all(shown.layers.front().pixels) / mean_of_all(made.layers.front().pixels);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 0.02) << "other rays, the same light";
}

TEST(Field, LightPathsAndPencilsFillTheSameTexels) {
    const Scene scene = coloured_room();
    RenderOptions options = field_options();
    options.pencils = 4;
    const RenderResult made = render(scene, options, device());
    ASSERT_TRUE(made.field);
    ReferenceOptions paths;
    paths.field = made.field;
    paths.spp = 256;
    paths.bounces = true;
    const ReferenceResult traced = trace_paths(scene, paths);
    ASSERT_EQ(traced.width, made.field->width());
    const std::vector<float>&a = traced.layers.front().pixels, &b = made.field->light;
    ASSERT_EQ(a.size(), b.size());
    double square = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        square += static_cast<double>(a[i]) * a[i];
        difference += static_cast<double>(a[i] - b[i]) * (a[i] - b[i]);
    }
    std::printf("root mean square of the difference of texels, relative: %.3f\n", std::sqrt(difference / square));
    EXPECT_LT(difference, 0.02 * square) << "a turned or mirrored map differs by about as much as it holds";
    const dvec3 ratio = mean_of_all(b) / mean_of_all(a);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 0.04);
}

TEST(Field, IsShownFromAnyCameraAndByEveryFormOfWeights) {
    Scene scene = coloured_room();
    const RenderResult made = render(scene, field_options(), device());
    look_at(scene, {0.1, 0.2, 0.1}, {0.9, 0.6, 0.9}, {0, 1, 0}, 80.0, 24, 24);
    ReferenceOptions reference;
    reference.spp = 512;
    reference.width = reference.height = 24;
    const dvec3 truth = mean_of_all(trace_paths(scene, reference).layers.front().pixels);
    const auto ratio = [&](MethodName method, Weights weights) {
        RenderOptions options = field_options();
        options.keep_field = false;
        options.field = made.field;
        options.method = method;
        options.weights = weights;
        options.width = options.height = 24;
        return mean_of_all(render(scene, options, device()).layers.front().pixels) / truth;
    };
    const dvec3 hybrid = ratio(MethodName::hybrid, Weights::dpdf);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(hybrid[c], 1.0, 0.04);
    for (const Weights weights : {Weights::dpdf, Weights::voronoi, Weights::analytic}) {
        const dvec3 line = ratio(MethodName::line, weights);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(line[c], 1.0, 0.25) << "lines lose the light of near walls";
    }
}

/// A ball in the room, so that films have edges and normals that turn.
Scene room_with_a_ball() {
    Scene scene = coloured_room();
    std::vector<Face> ball = inward_sphere(0.25, 24);
    for (Face& face : ball) {
        std::swap(face[0], face[2]);
        for (dvec3& corner : face) corner += dvec3(0.5, 0.3, 0.5);
    }
    add_shape(scene, "ball", ball, {{0.6F, 0.6F, 0.6F}, glm::vec3(0.0F), false});
    return scene;
}

double relative_difference(const std::vector<float>& a, const std::vector<float>& b) {
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        difference += std::abs(static_cast<double>(a[i] - b[i]));
        sum += static_cast<double>(b[i]);
    }
    return difference / sum;
}

RenderOptions shown_by(const RenderResult& made, MethodName method, bool thin) {
    RenderOptions options = field_options();
    options.keep_field = false;
    options.field = made.field;
    options.method = method;
    options.weights = Weights::analytic;
    options.thin = thin;
    return options;
}

TEST(Field, AViewIsTheRenderFromThere) {
    Scene scene = room_with_a_ball();
    const RenderResult made = render(scene, field_options(), device());
    for (const MethodName method : {MethodName::line, MethodName::hybrid})
        for (const bool thin : {false, true}) {
            RenderSession session(scene, shown_by(made, method, thin), device());
            while (session.advance()) {
            }
            Scene there = scene;
            for (const double x : {0.1, 0.8}) {
                look_at(there, {x, 0.2, 0.1}, {0.9, 0.6, 0.9}, {0, 1, 0}, 70.0, 32, 32);
                session.look(there.sensor);
                const RenderResult fresh = render(there, shown_by(made, method, thin), device());
                EXPECT_LT(relative_difference(session.snapshot().front().pixels, fresh.layers.front().pixels), 2e-3) << x << thin;
            }
        }
    RenderSession surface(scene, RenderOptions(), device());
    EXPECT_THROW(surface.look(scene.sensor), UsageError);
}

TEST(Field, AThinFilmShowsTheSame) {
    Scene scene = room_with_a_ball();
    const RenderResult made = render(scene, field_options(), device());
    RenderOptions every = shown_by(made, MethodName::line, false), thin = shown_by(made, MethodName::line, true);
    every.width = thin.width = 95;
    every.height = thin.height = 64;
    const RenderResult a = render(scene, thin, device()), b = render(scene, every, device());
    const double difference = relative_difference(a.layers.front().pixels, b.layers.front().pixels);
    std::printf("thin film, mean difference: %.4f\n", difference);
    EXPECT_GT(difference, 0.0);
    EXPECT_LT(difference, 0.02);
    const dvec3 ratio = mean_of_all(a.layers.front().pixels) / mean_of_all(b.layers.front().pixels);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 3e-3);
}

TEST(Field, HoldsNoEmission) {
    const Scene scene = lit_wall_box();
    RenderOptions options = field_options();
    options.method = MethodName::line;
    options.weights = Weights::voronoi;
    options.initial = Initial::emission;
    options.iterate = Iterate::levels;
    options.pencils = 64;
    const RenderResult made = render(scene, options, device());
    ASSERT_TRUE(made.field);
    options.keep_field = false;
    const dvec3 direct = mean_of_all(render(scene, options, device()).layers.front().pixels);
    options.field = made.field;
    options.iterate = Iterate::sets;
    const dvec3 ratio = mean_of_all(render(scene, options, device()).layers.front().pixels) / direct;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 0.02) << "direct light twice is 1.4";
}

TEST(Field, IsShownWhereTheSceneHasNoLight) {
    Scene scene = coloured_room();
    const RenderResult made = render(scene, field_options(), device());
    scene.point_lights.clear();
    RenderSession session(scene, shown_by(made, MethodName::line, false), device());
    while (session.advance()) {
    }
    EXPECT_GT(mean_of_all(session.snapshot().front().pixels).x, 0.0);
    EXPECT_NO_THROW(session.look(scene.sensor));
}

TEST(Field, HasTheOrdersThatItWasMadeWith) {
    RenderOptions options = field_options();
    options.bounces = 3;
    const RenderResult made = render(coloured_room(), options, device());
    ASSERT_TRUE(made.field);
    EXPECT_EQ(made.field->orders, 2) << "the film makes the third";
    options.field = made.field;
    EXPECT_NO_THROW(render(coloured_room(), options, device()));
    for (const int bounces : {0, 1, 2, 4, endless_bounces}) {
        options.bounces = bounces;
        EXPECT_THROW(render(coloured_room(), options, device()), UsageError) << bounces;
    }
}

TEST(Field, ByLightPathsHoldsReflectedLightAlone) {
    Scene scene = coloured_room();
    scene.point_lights.clear();
    add_quad(scene, "lamp", {0.3, 0.95, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.0F), glm::vec3(10.0F), false});
    auto field = std::make_shared<PencilField>();
    field->map = 16;
    field->centres = {{0.5, 0.5, 0.5}};
    ReferenceOptions paths;
    paths.field = field;
    paths.spp = 64;
    paths.max_depth = 1;
    const ReferenceResult emission = trace_paths(scene, paths);
    ASSERT_EQ(emission.layers.size(), 1U);
    expect_zero(emission.layers.front());
    paths.max_depth = 2;
    const std::vector<float> light = trace_paths(scene, paths).layers.front().pixels;
    EXPECT_LT(*std::max_element(light.begin(), light.end()), 5.0F) << "the lamp itself shows";
    EXPECT_GT(*std::max_element(light.begin(), light.end()), 0.0F);
}

TEST(Field, OfAnotherSceneIsRefused) {
    const RenderResult made = render(coloured_room(), field_options(), device());
    auto moved = std::make_shared<PencilField>(*made.field);
    moved->centres[3].y = 2.0;
    RenderOptions options = field_options();
    options.field = moved;
    EXPECT_THROW(render(coloured_room(), options, device()), UsageError);
}

}  // namespace
}  // namespace pencil::test
