// Closed furnace: every wall emits 1 and reflects a. Radiance is 1 / (1 - a) everywhere and the k-th reflection adds a^k. Every
// self-normalised estimator passes; leaks, lost bounces, wrong closure of the series and double counting fail.
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr double promised = 1e-3;

RenderOptions emission_options() {
    RenderOptions options = line_options();
    options.initial = Initial::emission;
    options.pencils = 64;
    options.map = 32;
    options.film_samples = 4;
    return options;
}

struct Form {
    const char* name;
    Iterate iterate;
    Weights weights;
    Placement placement;
};
std::ostream& operator<<(std::ostream& out, const Form& form) { return out << form.name; }

class Furnace : public testing::TestWithParam<Form> {
protected:
    RenderOptions options() const {
        RenderOptions out = emission_options();
        out.iterate = GetParam().iterate;
        out.weights = GetParam().weights;
        out.placement = {GetParam().placement};
        return out;
    }
};
INSTANTIATE_TEST_SUITE_P(Form, Furnace,
                         testing::Values(Form{"sets", Iterate::sets, Weights::dpdf, Placement::lds},
                                         Form{"fixed", Iterate::fixed, Weights::dpdf, Placement::lds},
                                         Form{"voronoi_sets", Iterate::sets, Weights::voronoi, Placement::random},
                                         Form{"voronoi_fixed", Iterate::fixed, Weights::voronoi, Placement::lds},
                                         Form{"analytic_sets", Iterate::sets, Weights::analytic, Placement::lds},
                                         Form{"analytic_fixed", Iterate::fixed, Weights::analytic, Placement::random}),
                         [](const auto& test) { return test.param.name; });

TEST_P(Furnace, BeautyIsTheWholeSeries) {
    for (const float albedo : {0.5F, 0.8F}) {
        RenderOptions options = this->options();
        options.tolerance = 1e-4;  // the part left out is then below a^k / (1 - a) < promised / 2
        const RenderResult result = render_layers(furnace(albedo), options);
        SCOPED_TRACE(albedo);
        expect_uniform(layer(result, ""), 1.0 / (1.0 - static_cast<double>(albedo)), promised);
    }
}

TEST_P(Furnace, BouncesArePowersOfTheAlbedo) {
    RenderOptions options = this->options();
    options.bounces = 4;
    const double a = 0.8F;
    const RenderResult result = render_layers(furnace(0.8F), options, {"emission", "direct", "bounces"});
    expect_uniform(layer(result, "emission"), 1.0, promised);
    expect_uniform(layer(result, "direct"), a, promised);
    for (int k = 2; k <= 4; ++k) expect_uniform(layer(result, "bounce" + std::to_string(k)), std::pow(a, k), promised);
    expect_uniform(layer(result, ""), (1.0 - std::pow(a, 5)) / (1.0 - a), promised);
    ASSERT_EQ(result.stats.bounces.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(result.stats.bounces[k].order, static_cast<int>(k) + 1);
        EXPECT_NEAR(result.stats.bounces[k].mean.x, std::pow(a, k + 1), promised) << "report of bounce " << k + 1;
    }
}

TEST_P(Furnace, ResidualCoversTheError) {
    const RenderOptions options = this->options();
    const RenderResult result = render_layers(furnace(0.9F), options);
    const double truth = 1.0 / (1.0 - 0.9F), error = std::abs(pixel(layer(result, ""), 0).x / truth - 1.0);
    EXPECT_LE(error, 1.5 * result.stats.residual + promised) << "residual " << result.stats.residual;
    EXPECT_LE(error, 0.02) << "a series cut at 1e-3 of the sum may miss a / (1 - a) times that, 0.9 %";
}

TEST(FurnaceDepth, BouncesAreCountedExactly) {
    for (int bounces = 0; bounces <= 2; ++bounces) {
        RenderOptions options = emission_options();
        options.bounces = bounces;
        SCOPED_TRACE(bounces);
        expect_uniform(layer(render_layers(furnace(0.5F), options), ""), 2.0 * (1.0 - std::pow(0.5, bounces + 1)), promised);
    }
}

double mean_direct_by_samples(int samples) {
    RenderOptions options = emission_options();
    options.initial = Initial::direct;
    options.bounces = 1;
    options.map = 16;
    options.light_samples = samples;
    const RenderResult result = render_layers(furnace(0.5F), options, {"direct"});
    const Layer& direct = layer(result, "direct");
    double mean = 0.0;
    for (const float value : direct.pixels) mean += value / static_cast<double>(direct.pixels.size());
    return mean;
}

TEST(FurnaceDepth, LightSamplesConvergeToEmission) {
    // Samples of walls that meet the lit point: the disc form factor loses light near the edges, as the square root of a sample's area.
    const double few = mean_direct_by_samples(256), many = mean_direct_by_samples(2048);
    EXPECT_NEAR(many, 0.5, 0.02);
    EXPECT_LT(std::abs(many - 0.5), 0.7 * std::abs(few - 0.5)) << "few " << few << " many " << many;
}

}  // namespace
