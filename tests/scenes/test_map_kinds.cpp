// Renders with every kind of map: the furnace is exact, a dark room stays dark, and a room is the same but for the noise of coarse maps.
#include "options/pencil_field.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "util/error.h"

namespace pencil::test::map_kinds {
namespace {

std::string name_of(const testing::TestParamInfo<MapKind>& test) {
    const char* const names[] = {"octahedral", "pyramid", "cube", "paraboloid"};
    return names[static_cast<int>(test.param)];
}

class MapKindRenders : public testing::TestWithParam<MapKind> {
protected:
    static RenderOptions options(MethodName method = MethodName::line) {
        RenderOptions out = line_options();
        out.method = method;
        out.map_kind = GetParam();
        out.pencils = 32;
        out.map = 32;
        out.film_samples = 4;
        return out;
    }
};
INSTANTIATE_TEST_SUITE_P(Kinds, MapKindRenders,
                         testing::Values(MapKind::octahedral, MapKind::pyramid, MapKind::cube, MapKind::paraboloid), name_of);

TEST_P(MapKindRenders, FurnaceIsExact) {
    const double a = 0.8F;
    for (const auto& [method, weights, iterate] :
         {std::tuple{MethodName::line, Weights::dpdf, Iterate::sets}, std::tuple{MethodName::line, Weights::voronoi, Iterate::fixed},
          std::tuple{MethodName::line, Weights::analytic, Iterate::sets}, std::tuple{MethodName::hybrid, Weights::dpdf, Iterate::sets}}) {
        RenderOptions o = options(method);
        o.initial = Initial::emission;
        o.weights = weights;
        o.iterate = iterate;
        o.bounces = 3;
        const RenderResult result = render_layers(furnace(0.8F), o, {"direct", "bounces"});
        if (method == MethodName::line) expect_uniform(layer(result, "direct"), a, 1e-3);
        for (int k = 2; k <= 3; ++k) expect_uniform(layer(result, "bounce" + std::to_string(k)), std::pow(a, k), 1e-3);
    }
}

double mean(const Layer& image) {
    double sum = 0.0;
    for (const float value : image.pixels) sum += value;
    return sum / static_cast<double>(image.pixels.size());
}

TEST_P(MapKindRenders, NoLightThroughASheet) {
    // As in test_darkness.cpp: where wall, floor and sheet meet in one point, that point may lie between the texels of a map.
    constexpr double corner_leak = 1e-5;
    for (const Initial initial : {Initial::direct, Initial::emission}) {
        RenderOptions o = options();
        o.initial = initial;
        o.bounces = 3;
        Scene scene = two_rooms(0.0, true);
        const RenderResult dark = render_layers(scene, o, {"direct"});
        if (initial == Initial::direct) expect_zero(layer(dark, "direct"));
        look_at(scene, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 64, 64);
        const double leak = mean(layer(dark, "")) / mean(layer(render_layers(scene, o), ""));
        std::printf("leak through a sheet, relative: %.2e\n", leak);
        EXPECT_LE(leak, corner_leak);
    }
}

/// Root of the mean square of differences relative to the mean.
double difference(const Layer& image, const Layer& other) {
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) sum += std::pow(static_cast<double>(image.pixels[i] - other.pixels[i]), 2.0);
    return std::sqrt(sum / static_cast<double>(image.pixels.size())) / mean(other);
}

TEST_P(MapKindRenders, ARoomIsThatOfOctahedralMaps) {
    Scene scene = room_of_everything();
    for (const MethodName method : {MethodName::line, MethodName::hybrid}) {
        RenderOptions o = options(method), octahedral = o;
        octahedral.map_kind = MapKind::octahedral;
        o.map = octahedral.map = 64;
        o.bounces = octahedral.bounces = 3;
        const RenderResult result = render_layers(scene, o), same = render_layers(scene, octahedral);
        const double ratio = mean(layer(result, "")) / mean(layer(same, "")), apart = difference(layer(result, ""), layer(same, ""));
        std::printf("mean %.5f times, differences %.4f of the mean\n", ratio, apart);
        EXPECT_NEAR(ratio, 1.0, 0.01);
        EXPECT_LE(apart, 0.03);
    }
}

TEST(MapKinds, FieldsAreOctahedral) {
    RenderOptions o = line_options();
    o.map_kind = MapKind::cube;
    o.keep_field = true;
    EXPECT_THROW(render_layers(furnace(0.5F), o), UsageError);
}

}  // namespace
}  // namespace pencil::test::map_kinds
