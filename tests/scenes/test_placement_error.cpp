// Which placement is how wrong, and that pooling two sets costs nothing: the weights of a pooled set are those of the balance heuristic
// (docs/equations.md), so that it must not be worse than the better of its parts alone by more than noise.
//   test_scenes --gtest_also_run_disabled_tests --gtest_filter='*PlacementError*Table*'   prints the table of docs/accuracy.md.
#include <cstdio>

#include "reference/path_tracer.h"
#include "scene/formats/load_scene.h"
#include "scenes/lit_wall.h"

namespace {

using namespace pencil;
using namespace pencil::test;

using Mixture = std::vector<Placement>;

/// Mean of a squared error over seeds, with its standard error.
struct Error {
    double mean = 0, noise = 0;
};
template <typename OfSeed>
Error over_seeds(int seeds, OfSeed error) {
    double sum = 0, squares = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        const double e = error(static_cast<std::uint64_t>(seed));
        sum += e;
        squares += e * e;
    }
    const double mean = sum / seeds, variance = (squares / seeds - mean * mean) * seeds / (seeds - 1.0);
    return {mean, std::sqrt(std::max(variance, 0.0) / seeds)};
}

RenderOptions options(const Mixture& mixture, int pencils, std::uint64_t seed) {
    RenderOptions o = line_options();
    o.placement = mixture;
    o.pencils = pencils;
    o.seed = seed;
    o.map = 32;
    return o;
}

/// Mean squared relative error of the irradiance at the five places.
double lit_wall_error(const Mixture& mixture, int pencils, std::uint64_t seed) {
    double sum = 0;
    for (const double ratio : lit_wall_ratios(options(mixture, pencils, seed))) sum += (ratio - 1.0) * (ratio - 1.0) / 5.0;
    return sum;
}

/// Mean squared error of indirect light in the Cornell box, relative to its mean square; the truth is path traced.
class Cornell {
public:
    Cornell() : scene_(load_scene(std::filesystem::path(PENCIL_SOURCE_DIR) / "scenes" / "cornell-box.xml")) {
        ReferenceOptions o;
        o.width = o.height = size;
        o.spp = 4096;
        o.max_depth = 3;
        o.bounces = true;
        truth_ = layer(trace_paths(scene_, o).layers, "bounce2");
    }
    double error(const Mixture& mixture, int pencils, std::uint64_t seed) const {
        RenderOptions o = options(mixture, pencils, seed);
        o.width = o.height = size;
        o.bounces = 2;
        const RenderResult result = render_layers(scene_, o, {"bounces"});
        const Layer& image = layer(result, "bounce2");
        double sum = 0, all = 0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const double r = truth_.pixels[i], d = image.pixels[i] - r;
            sum += d * d;
            all += r * r;
        }
        return sum / all;
    }

private:
    static constexpr int size = 32;
    Scene scene_;
    Layer truth_;
};

/// A (n pencils), B (n pencils), and their union (2 n).
template <typename ErrorOf>
void expect_union_not_worse(Placement a, Placement b, int n, int seeds, const char* what, const ErrorOf& error) {
    const auto of = [&](const Mixture& m, int count) {
        return over_seeds(seeds, [&](std::uint64_t seed) { return error(m, count, seed); });
    };
    const Error first = of({a}, n), second = of({b}, n), pooled = of({a, b}, 2 * n);
    const Error& better = first.mean < second.mean ? first : second;
    std::printf("%s, placements %d and %d, n = %d: %.4f (%.4f), %.4f (%.4f), union of 2 n %.4f (%.4f)\n", what, static_cast<int>(a),
                static_cast<int>(b), n, first.mean, first.noise, second.mean, second.noise, pooled.mean, pooled.noise);
    EXPECT_LE(pooled.mean, better.mean + 2.0 * std::hypot(better.noise, pooled.noise)) << what;
}

TEST(PlacementError, AUnionIsNotWorseThanItsBetterPartOnTheLitWall) {
    for (const auto& [a, b] :
         {std::pair{Placement::lds, Placement::near_surface}, std::pair{Placement::light_rays, Placement::camera_rays}})
        expect_union_not_worse(a, b, 64, 4, "lit wall", lit_wall_error);
}

TEST(PlacementError, AUnionIsNotWorseThanItsBetterPartInTheCornellBox) {
    const Cornell cornell;
    const auto error = [&](const Mixture& m, int n, std::uint64_t seed) { return cornell.error(m, n, seed); };
    for (const auto& [a, b] : {std::pair{Placement::lds, Placement::near_surface}, std::pair{Placement::light_rays, Placement::camera_rays},
                               std::pair{Placement::lds, Placement::profile}})
        expect_union_not_worse(a, b, 64, 4, "Cornell box", error);
}

TEST(PlacementError, DISABLED_TableOfDocsAccuracy) {
    constexpr int seeds = 4;
    const std::vector<std::pair<const char*, Mixture>> rows{
        {"random", {Placement::random}},
        {"lds", {Placement::lds}},
        {"near-surface", {Placement::near_surface}},
        {"light-rays", {Placement::light_rays}},
        {"camera-rays", {Placement::camera_rays}},
        {"profile", {Placement::profile}},
        {"lds+near-surface", {Placement::lds, Placement::near_surface}},
        {"lds+camera-rays", {Placement::lds, Placement::camera_rays}},
        {"near-surface+camera-rays", {Placement::near_surface, Placement::camera_rays}}};
    std::printf("irradiance of the lit wall, rendered / exact, mean over %d seeds (RMSE %%)\n| placement | pencils |", seeds);
    for (const Place& place : places) std::printf(" %s |", place.name);
    std::printf("\n|---|---|---|---|---|---|---|\n");
    for (const int pencils : {128, 512}) {
        for (const auto& [name, mixture] : rows) {
            std::array<double, 5> mean{}, square{};
            for (std::uint64_t seed = 0; seed < seeds; ++seed) {
                RenderOptions o = options(mixture, pencils, seed);
                o.map = 64;
                const std::array<double, 5> r = lit_wall_ratios(o);
                for (std::size_t p = 0; p < r.size(); ++p) {
                    mean[p] += r[p] / seeds;
                    square[p] += (r[p] - 1.0) * (r[p] - 1.0) / seeds;
                }
            }
            std::printf("| %s | %d |", name, pencils);
            for (std::size_t p = 0; p < places.size(); ++p) std::printf(" %.3f (%.0f) |", mean[p], 100.0 * std::sqrt(square[p]));
            std::printf("\n");
            std::fflush(stdout);
        }
    }
}

}  // namespace
