// What the path tracer promises beside right answers: an honest variance, equal bits, independence of scale, and what it does with
// unusual input.
#include <atomic>
#include <cmath>
#include <numeric>
#include <thread>

#include "image/relative_error.h"
#include "reference_renderer/traced.h"
#include "util/error.h"

namespace {

using namespace pencil;
using namespace pencil::test;

ReferenceOptions everything(int spp) {
    ReferenceOptions options;
    options.spp = spp;
    options.bounces = options.surfaces = options.variance = true;
    return options;
}

void expect_same_bits(const ReferenceResult& a, const ReferenceResult& b) {
    ASSERT_EQ(a.layers.size(), b.layers.size());
    for (std::size_t k = 0; k < a.layers.size(); ++k) {
        EXPECT_EQ(a.layers[k].name, b.layers[k].name);
        EXPECT_TRUE(a.layers[k].pixels == b.layers[k].pixels) << "layer \"" << a.layers[k].name << "\"";
    }
}

TEST(PathTracer, VarianceIsThatOfRepeatedRenders) {
    constexpr int seeds = 128;
    std::vector<double> sum(3 * 20 * 14), squares = sum, told = sum;
    for (int seed = 0; seed < seeds; ++seed) {
        const ReferenceResult result = trace(room_of_everything(), 40, -1, static_cast<std::uint64_t>(seed));
        const std::vector<float>&image = layer(result.layers, "").pixels, &variance = layer(result.layers, "variance").pixels;
        for (std::size_t i = 0; i < sum.size(); ++i) {
            sum[i] += image.at(i);
            squares[i] += static_cast<double>(image[i]) * image[i];
            told[i] += static_cast<double>(variance.at(i)) / seeds;
        }
    }
    double ratios = 0;
    int values = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
        if (told[i] == 0) continue;
        ratios += (squares[i] - sum[i] * sum[i] / seeds) / (seeds - 1) / told[i];
        ++values;
    }
    EXPECT_GT(values, 700);
    EXPECT_NEAR(ratios / values, 1.0, 0.04) << "each variance is found to 13 % or somewhat worse, and channels are not independent";
}

/// What a render says of its own error, against many more paths; without the variance layer it has two sets only.
TEST(PathTracer, EstimatedErrorIsTheTrueOne) {
    ReferenceOptions options;
    options.spp = 8192;
    options.seed = 1000;
    const ReferenceResult truth = trace_paths(room_of_everything(), options);
    const std::vector<float>& r = layer(truth.layers, "").pixels;
    const double mean = std::accumulate(r.begin(), r.end(), 0.0) / static_cast<double>(r.size());
    double true_error = 0, estimated = 0;
    constexpr int seeds = 16;
    for (int seed = 0; seed < seeds; ++seed) {
        options.spp = 64;
        options.seed = static_cast<std::uint64_t>(seed);
        const ReferenceResult result = trace_paths(room_of_everything(), options);
        const std::vector<float>& x = layer(result.layers, "").pixels;
        for (std::size_t i = 0; i < x.size(); ++i) true_error += relative_square(x[i], r[i], mean) / static_cast<double>(seeds * x.size());
        estimated += result.estimated_error / seeds;
    }
    EXPECT_NEAR(estimated / true_error, 1.0, 0.15);
    options.spp = 1;
    EXPECT_TRUE(std::isinf(trace_paths(room_of_everything(), options).estimated_error));
}

TEST(PathTracer, SameBitsWhateverTheThreads) {
    ReferenceOptions options = everything(24);
    options.seed = 18446744073709551615ULL;
    const ReferenceResult first = trace_paths(room_of_everything(), options);
    for (const int threads : {1, 2, 5}) {
        options.threads = threads;
        expect_same_bits(first, trace_paths(room_of_everything(), options));
    }
    options.seed = 1;
    EXPECT_FALSE(layer(first.layers, "").pixels == layer(trace_paths(room_of_everything(), options).layers, "").pixels)
        << "another seed, another noise";
}

TEST(PathTracer, ScaleChangesNothingAndTranslationOnlyRounding) {
    const Scene scene = room_of_everything();
    const ReferenceResult plain = trace(scene, 64);
    for (const double scale : {0x1p-30, 0x1p40}) {
        Scene scaled = scene;
        for (dvec3& p : scaled.positions) p *= scale;
        for (PointLight& light : scaled.point_lights) {
            light.position *= scale;
            light.intensity *= static_cast<float>(scale) * static_cast<float>(scale);
        }
        scaled.sensor.to_world[3] = glm::dvec4(dvec3(scene.sensor.to_world[3]) * scale, 1);
        scaled.sensor.near_clip *= scale;
        scaled.sensor.far_clip *= scale;
        expect_same_bits(plain, trace(scaled, 64));
    }
    Scene moved = scene;
    const dvec3 far_away(3e6, -7e6, 1e6);
    for (dvec3& p : moved.positions) p += far_away;
    for (PointLight& light : moved.point_lights) light.position += far_away;
    moved.sensor.to_world[3] += glm::dvec4(far_away, 0);
    const Estimate a = mean_of_image(plain), b = mean_of_image(trace(moved, 64));
    EXPECT_NEAR(a.mean, b.mean, 0.3 * a.error) << "the same paths but for rounding";
}

TEST(PathTracer, OneShapeOfManyMaterialsIsManyShapes) {
    Scene one = room_of_everything();
    for (Triangle3& t : one.triangles)
        if (!one.shapes[t.shape].emits) t.shape = 0;
    expect_same_bits(trace_paths(room_of_everything(), everything(16)), trace_paths(one, everything(16)));
}

TEST(PathTracer, CameraFarAway) {
    Scene scene = room_of_everything();
    look_at(scene, {0, 0, 3e6}, dvec3(0), {0, 1, 0}, 45.0 / 1e6, 16, 16);
    scene.sensor.far_clip = 1e9;
    ReferenceOptions options = everything(16);
    const ReferenceResult result = trace_paths(scene, options);
    // The middle of the back wall, at z = -1.
    EXPECT_NEAR(pixel(layer(result.layers, "position"), 16 * 3 + 11).z, -1.0, 1e-5);
    EXPECT_GT(mean_of_image(result).mean, 0.01);
}

TEST(PathTracer, SurfaceLayersAndClipping) {
    Scene scene;
    add_quad(scene, "near", {-1, -1, 2}, {0, 2, 0}, {2, 0, 0}, {glm::vec3(0.25F), glm::vec3(0.0F), false});
    add_quad(scene, "far", {-9, -9, 4}, {0, 18, 0}, {18, 0, 0}, {glm::vec3(0.75F), glm::vec3(0.0F), false});
    look_at(scene, dvec3(0), {0, 0, 1}, {0, 1, 0}, 20.0, 8, 8);
    ReferenceOptions options = everything(4);
    const auto albedo_and_depth = [&] {
        const ReferenceResult result = trace_paths(scene, options);
        EXPECT_NEAR(pixel(layer(result.layers, "normal"), 36).z, layer(result.layers, "depth").pixels[36] > 0 ? -1.0 : 0.0, 1e-6);
        return std::pair{pixel(layer(result.layers, "albedo"), 36).x, static_cast<double>(layer(result.layers, "depth").pixels[36])};
    };
    EXPECT_NEAR(albedo_and_depth().first, 0.25, 1e-6);
    EXPECT_NEAR(albedo_and_depth().second, 2.0, 0.01);
    scene.sensor.near_clip = 2.001;  // depths along the axis
    EXPECT_NEAR(albedo_and_depth().first, 0.75, 1e-6);
    scene.sensor.far_clip = 3.999;
    EXPECT_EQ(albedo_and_depth().second, 0.0);
    scene.sensor.near_clip = 1.999;
    EXPECT_NEAR(albedo_and_depth().first, 0.25, 1e-6);
}

TEST(PathTracer, ShadingNormalsLightTheSideThatTheyFace) {
    // The same floor, its normals leaning towards the light by 45 degrees: the cosine is that of the normal.
    Scene scene;
    add_quad(scene, "floor", {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, {glm::vec3(0.5F), glm::vec3(0.0F), false});
    for (glm::vec3& n : scene.normals) n = glm::normalize(glm::vec3(1, 1, 0));
    scene.point_lights.push_back({{1000, 1000, 0}, glm::vec3(2e6F)});
    look_at(scene, {0, 0.1, 0}, dvec3(0), {0, 0, 1}, 1.0, 4, 4);
    expect_mean(trace(scene, 16), 0.5 / ref::pi, 1e-4, "normal towards the light");
    scene.point_lights[0].position = {-1000, 900, 0};
    expect_zero(layer(trace(scene, 4).layers, ""));
    scene.point_lights[0].position = {1000, -500, 0};  // in front of the shading normal, behind the floor
    expect_zero(layer(trace(scene, 4).layers, ""));
}

TEST(PathTracer, OneSidedAndTwoSided) {
    for (const bool both : {false, true}) {
        Scene scene;
        add_quad(scene, "floor", {-2, 0, -2}, {4, 0, 0}, {0, 0, 4}, {glm::vec3(0.5F), glm::vec3(0.0F), both});  // its back looks up
        scene.point_lights.push_back({{0, 1, 0}, glm::vec3(1.0F)});
        look_at(scene, {0, 0.1, 0}, dvec3(0), {0, 0, 1}, 0.1, 2, 2);
        EXPECT_NEAR(pixel(layer(trace(scene, 4).layers, ""), 0).x, both ? 0.5 / ref::pi : 0.0, 1e-5);
    }
    Scene lamp;  // emitters shine to the front only, even where both sides reflect
    add_quad(lamp, "lamp", {-2, 0, -2}, {4, 0, 0}, {0, 0, 4}, {glm::vec3(0.5F), glm::vec3(1.0F), true});
    look_at(lamp, {0, 0.1, 0}, dvec3(0), {0, 0, 1}, 0.1, 2, 2);
    expect_zero(layer(trace(lamp, 4).layers, ""));
    look_at(lamp, {0, -0.1, 0}, dvec3(0), {0, 0, 1}, 0.1, 2, 2);
    expect_uniform(layer(trace(lamp, 4).layers, ""), 1.0, 1e-6);
}

TEST(PathTracer, ATimeBudgetTracesWholePasses) {
    ReferenceOptions options;
    options.seconds = 1e-9;  // over before the first pass is: how much a longer one affords is SamplePlan's to say
    const ReferenceResult result = trace_paths(room_of_everything(), options);
    EXPECT_GE(result.spp, 1) << "never less than one path per pixel";
    EXPECT_EQ(result.paths, static_cast<std::uint64_t>(result.spp) * 20 * 14);
}

TEST(PathTracer, StopsWhenToldAndKeepsWhatIsDone) {
    ReferenceOptions options = everything(1 << 20);
    std::atomic<int> calls{0}, inside{0}, most_inside{0};
    const ReferenceResult result = trace_paths(room_of_everything(), options, [&](const std::string& stage, double fraction) {
        most_inside = std::max<int>(most_inside, ++inside);
        EXPECT_TRUE(stage == "build BVH" || stage == "trace paths") << stage;
        EXPECT_TRUE(fraction >= 0 && fraction <= 1) << fraction;
        --inside;
        return ++calls < 50;
    });
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(most_inside, 1);
    EXPECT_GT(result.spp, 0);
    EXPECT_LT(result.spp, 1 << 20);
    const Estimate e = mean_of_image(result), truth = mean_of_image(trace(room_of_everything(), 400));
    EXPECT_NEAR(e.mean, truth.mean, 4 * (e.error + truth.error)) << "tiles with more samples and with fewer are all right";
}

TEST(PathTracer, StoppedAtOnceIsBlackAndSaysSo) {
    const ReferenceResult result = trace_paths(room_of_everything(), everything(16), [](const std::string&, double) { return false; });
    EXPECT_TRUE(result.interrupted);
    EXPECT_EQ(result.spp, 0);
    EXPECT_FALSE(result.warnings.empty());
    expect_zero(layer(result.layers, ""));
}

/// Light is counted in a unit of its own: only what does not fit the image in the end, here the variance, is cut, and said to be.
TEST(PathTracer, LightAtTheEndOfFloatsRangeIsKept) {
    Scene scene = room_of_everything();
    for (Shape& shape : scene.shapes)
        if (shape.emits) shape.radiance = glm::vec3(3e38F);
    const ReferenceResult result = trace(scene, 16);
    for (const float value : layer(result.layers, "").pixels) ASSERT_TRUE(std::isfinite(value));
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_NE(result.warnings[0].find("layer variance are too large for float"), std::string::npos) << result.warnings[0];
}

TEST(PathTracer, WithoutLightOrGeometryIsBlack) {
    Scene scene;
    look_at(scene, dvec3(0), {0, 0, 1}, {0, 1, 0}, 90.0, 4, 4);
    const ReferenceResult empty = trace_paths(scene, everything(4));
    for (const Layer& image : empty.layers) expect_zero(image);
    ASSERT_EQ(empty.warnings.size(), 1U);
    EXPECT_EQ(empty.warnings[0], "the scene has no light: the image is black");
    scene.point_lights.push_back({dvec3(0), glm::vec3(1.0F)});
    EXPECT_TRUE(trace_paths(scene, everything(4)).warnings.empty());
    scene.point_lights.clear();
    add_box(scene, dvec3(-1), dvec3(1), {glm::vec3(0.5F), glm::vec3(0.0F), false});
    const ReferenceResult dark = trace_paths(scene, everything(4));
    expect_zero(layer(dark.layers, ""));
    EXPECT_EQ(dark.warnings.size(), 1U);
}

TEST(PathTracer, OptionsOutOfRangeAreRefused) {
    const auto refused = [](const ReferenceOptions& options) { EXPECT_THROW(trace_paths(room_of_everything(), options), UsageError); };
    ReferenceOptions options;
    options.spp = 0;
    refused(options);
    options.spp = 1;
    options.max_depth = 0;
    refused(options);
    options.max_depth = -3;
    refused(options);
    options.max_depth = -1;
    options.threads = -1;
    refused(options);
}

TEST(PathTracer, OneSampleHasNoVariance) {
    const ReferenceResult result = trace(room_of_everything(), 1);
    expect_zero(layer(result.layers, "variance"));
    ASSERT_EQ(result.warnings.size(), 1U);
    EXPECT_NE(result.warnings[0].find("variance"), std::string::npos) << result.warnings[0];
}

}  // namespace
