// What must not change an image: units, place of the origin, order of the shapes, a second run.
#include <algorithm>

#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// A closed room with a lamp under its ceiling and a block on the floor; all lengths times `scale`, then moved by `offset`.
Scene room(double scale = 1.0, const dvec3& offset = dvec3(0.0), bool reversed = false) {
    const auto at = [&](double x, double y, double z) { return offset + scale * dvec3(x, y, z); };
    Scene scene;
    const auto walls = [&](int wall) {
        const std::array<glm::vec3, 6> colours{
            {{0.6F, 0.1F, 0.1F}, {0.1F, 0.5F, 0.1F}, {0.7F, 0.7F, 0.7F}, {0.7F, 0.7F, 0.7F}, {0.7F, 0.7F, 0.7F}, {0.2F, 0.3F, 0.8F}}};
        add_wall(scene, wall, at(0, 0, 0), at(1, 1, 1.25), {colours[static_cast<std::size_t>(wall)], glm::vec3(0.0F), false});
    };
    const auto lamp = [&] {
        add_quad(scene, "lamp", at(0.375, 0.96875, 0.375), scale * dvec3(0.25, 0, 0), scale * dvec3(0, 0, 0.25),
                 {glm::vec3(0.0F), glm::vec3(10.0F, 9.0F, 8.0F), false});
    };
    const auto block = [&] { add_box(scene, at(0.5625, 0, 0.5), at(0.8125, 0.5, 0.75), {glm::vec3(0.6F), glm::vec3(0.0F), false}, false); };
    if (reversed) {
        block();
        lamp();
        for (int wall = 5; wall >= 0; --wall) walls(wall);
    } else {
        for (int wall = 0; wall < 6; ++wall) walls(wall);
        lamp();
        block();
    }
    look_at(scene, at(0.25, 0.5, 0.0625), at(0.5, 0.375, 1), {0, 1, 0}, 70.0, 64, 48);
    scene.sensor.near_clip *= scale;
    scene.sensor.far_clip *= scale;
    return scene;
}

RenderOptions options() {
    RenderOptions out = line_options();
    out.pencils = 32;
    out.map = 32;
    out.bounces = 3;
    out.film_samples = 4;
    out.light_samples = 32;
    return out;
}

/// Pixels whose relative difference exceeds `relative`, and the relative difference of the means.
struct Difference {
    std::size_t pixels = 0, differing = 0;
    double mean = 0.0, worst = 0.0;
};
Difference compare(const RenderResult& a, const RenderResult& b, double relative) {
    const std::vector<float>&x = layer(a, "").pixels, &y = layer(b, "").pixels;
    Difference out;
    EXPECT_EQ(x.size(), y.size());
    if (x.size() != y.size() || x.empty()) return out;
    double sum_x = 0.0, sum_y = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double d = std::abs(x[i] - y[i]) / std::max(std::abs(x[i]), 1e-6F);
        out.worst = std::max(out.worst, d);
        if (!(d <= relative)) ++out.differing;
        sum_x += x[i];
        sum_y += y[i];
    }
    out.pixels = x.size();
    out.mean = std::abs(sum_x / sum_y - 1.0);
    EXPECT_GT(sum_x, 0.0) << "a black image proves nothing";
    return out;
}

// Float rounding may move a handful of edge pixels from one triangle to the other; everything else must agree.
constexpr double edge_pixels = 2e-3;

TEST(Invariance, PowerOfTwoUnitsChangeNoBit) {
    const RenderResult metres = render_layers(room(), options());
    for (const double scale : {1.0 / 1024.0, 1024.0})
        EXPECT_EQ(layer(metres, "").pixels, layer(render_layers(room(scale), options()), "").pixels) << scale;
}

TEST(Invariance, UnitsChangeNothing) {
    const RenderResult metres = render_layers(room(), options());
    for (const double scale : {1e-3, 1e3, 1e-6, 1e6}) {
        const Difference d = compare(metres, render_layers(room(scale), options()), 1e-5);
        EXPECT_LE(static_cast<double>(d.differing), edge_pixels * static_cast<double>(d.pixels))
            << "scale " << scale << ", worst " << d.worst;
        EXPECT_LE(d.mean, 1e-4) << "scale " << scale;
    }
}

TEST(Invariance, OriginChangesNothing) {
    const RenderResult here = render_layers(room(), options());
    for (const dvec3& offset : {dvec3(1e4, -1e4, 1e4), dvec3(4096, 0, 0)}) {
        const Difference d = compare(here, render_layers(room(1.0, offset), options()), 1e-5);
        EXPECT_LE(static_cast<double>(d.differing), edge_pixels * static_cast<double>(d.pixels))
            << "offset " << offset.x << ", worst " << d.worst;
        EXPECT_LE(d.mean, 1e-4) << "offset " << offset.x;
    }
}

TEST(Invariance, OrderOfShapesChangesNothing) {
    const Difference d = compare(render_layers(room(), options()), render_layers(room(1.0, dvec3(0.0), true), options()), 1e-4);
    EXPECT_LE(static_cast<double>(d.differing), edge_pixels * static_cast<double>(d.pixels)) << "worst " << d.worst;
    EXPECT_LE(d.mean, 1e-4);
}

/// Materials are of triangles, and shapes that do not emit are only names.
TEST(Invariance, OneShapeOfManyMaterialsIsManyShapes) {
    Scene one = room();
    for (Triangle3& t : one.triangles)
        if (!one.shapes[t.shape].emits) t.shape = 0;
    for (const MethodName method : {MethodName::line, MethodName::surface}) {
        RenderOptions both = options();
        both.method = method;
        if (method == MethodName::surface) both.target_error = 1e6;  // as few passes as may be
        const RenderResult a = render_layers(room(), both, {"albedo"}), b = render_layers(one, both, {"albedo"});
        EXPECT_EQ(layer(a, "").pixels, layer(b, "").pixels);
        EXPECT_EQ(layer(a, "albedo").pixels, layer(b, "albedo").pixels);
    }
}

TEST(Invariance, TwoRendersAreBitwiseEqual) {
    const RenderResult a = render_layers(room(), options(), {"direct", "bounces"}),
                       b = render_layers(room(), options(), {"direct", "bounces"});
    ASSERT_EQ(a.layers.size(), b.layers.size());
    for (std::size_t i = 0; i < a.layers.size(); ++i)
        EXPECT_EQ(a.layers[i].pixels, b.layers[i].pixels) << "layer \"" << a.layers[i].name << "\"";
}

TEST(Invariance, SeedsDiffer) {
    RenderOptions other = options();
    other.placement = {Placement::random};
    const RenderResult a = render_layers(room(), other);
    other.seed = 1;
    EXPECT_NE(layer(a, "").pixels, layer(render_layers(room(), other), "").pixels);
}

TEST(Invariance, LayersSumToTheBeauty) {
    const RenderResult result = render_layers(room(), options(), {"emission", "direct", "bounces"});
    const Layer &beauty = layer(result, ""), &emission = layer(result, "emission"), &direct = layer(result, "direct");
    const Layer &second = layer(result, "bounce2"), &third = layer(result, "bounce3");
    for (std::size_t i = 0; i < beauty.pixels.size(); ++i) {
        const double sum = static_cast<double>(emission.pixels[i]) + direct.pixels[i] + second.pixels[i] + third.pixels[i];
        ASSERT_NEAR(beauty.pixels[i], sum, 1e-5 * std::max(1.0, sum)) << "float " << i;
    }
}

}  // namespace
