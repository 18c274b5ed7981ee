// Light paths that check images: they find closed forms, and the error that they certify is the true one, bias included.
#include <cmath>

#include "certify/error_check.h"
#include "film/frame.h"
#include "reference/path_tracer.h"
#include "render/render_session.h"
#include "scenes/known_scenes.h"
#include "scenes/scene_builder.h"
#include "surface/surface_method.h"
#include "surface/surface_needs.h"

namespace {

using namespace pencil;
using namespace pencil::test;

/// The check of one film of a scene, with the scene's own options.
struct Checked {
    explicit Checked(const Scene& shown, int bounces = -1)
        : scene(shown), options(make_options(scene, bounces)), context(scene, options, surface_needs, device(), {}), check(context) {}

    static RenderOptions make_options(const Scene& scene, int bounces) {
        RenderOptions o;
        o.aovs = {};
        o = resolve(o, scene);
        o.bounces = bounces;
        return o;
    }

    void look(int paths, std::uint64_t seed) { look(check, paths, seed); }

    void look(ErrorCheck& with, int paths, std::uint64_t seed) {
        Frame frame(context, {}, 1, 0, Turn{seed});
        with.add_emission(frame.layers().beauty(), 1);
        with.add(frame.film(), paths, seed);
    }

    /// Of an image of the scene, which counts light in its own unit.
    CertifiedError certify(const ErrorCheck& by, std::vector<float> image) const {
        for (float& v : image) v = static_cast<float>(static_cast<double>(v) / context.flat.normalisation.light);
        return by.certify(image, image);
    }

    Scene scene;
    RenderOptions options;
    RenderContext context;
    ErrorCheck check;
};

std::vector<float> uniform_image(const Scene& scene, double value) {
    return std::vector<float>(static_cast<std::size_t>(3 * scene.sensor.width * scene.sensor.height), static_cast<float>(value));
}

/// A room with a lamp, a point light, a block and a sheet that is lit from both sides.
Scene closed_room() {
    Scene scene;
    const Surface grey{glm::vec3(0.7F, 0.5F, 0.3F), glm::vec3(0.0F), false}, both{glm::vec3(0.4F), glm::vec3(0.0F), true};
    for (int wall = 0; wall < 6; ++wall) add_wall(scene, wall, dvec3(-1), dvec3(1), grey);
    add_box(scene, {-0.5, -1, -0.3}, {0, -0.2, 0.3}, grey, false);
    add_quad(scene, "sheet", {0.3, -0.5, -0.2}, {0.4, 0.2, 0}, {0, 0.3, 0.4}, both);
    add_quad(scene, "lamp", {-0.3, 0.95, -0.3}, {0.6, 0, 0}, {0, 0, 0.6}, {glm::vec3(0.0F), glm::vec3(8.0F, 7.0F, 6.0F), false});
    scene.point_lights.push_back({{0.6, 0.2, 0.7}, glm::vec3(0.4F, 0.5F, 0.6F)});
    look_at(scene, {0.1, 0.3, -0.9}, {0, -0.2, 1}, {0, 1, 0}, 80.0, 40, 30);
    return scene;
}

std::vector<float> truth(const Scene& scene, int spp, std::uint64_t seed) {
    ReferenceOptions options;
    options.spp = spp;
    options.seed = seed;
    return trace_paths(scene, options).layers.front().pixels;
}

TEST(ErrorCheck, PathsFindTheFurnace) {
    for (const float albedo : {0.0F, 0.5F, 0.9F}) {
        const double expected = 1.0 / (1.0 - static_cast<double>(albedo));
        Checked checked(furnace(albedo));
        checked.look(1 << 15, 5);
        const CertifiedError found = checked.certify(checked.check, uniform_image(checked.scene, expected));
        EXPECT_GT(found.points, 100);
        EXPECT_NEAR(found.mean_bias, 0.0, 4.0 * found.mean_error + 1e-5) << "albedo " << albedo;
        EXPECT_LT(found.mean_error, 5e-3);
        EXPECT_NEAR(found.relmse, 0.0, 4.0 * found.standard_error + 1e-9);
    }
}

/// A black image is as wrong as can be where there is light; of one that holds no numbers nothing is said.
TEST(ErrorCheck, BlackImagesAreWrongAndBrokenOnesUnknown) {
    Checked checked(furnace(0.5F));
    checked.look(1 << 14, 5);
    // Emission is left out: the image shows it, and no reflection.
    const CertifiedError black = checked.certify(checked.check, uniform_image(checked.scene, 0.0));
    EXPECT_GT(black.points, 10);
    EXPECT_LT(black.mean_bias, -0.9);
    EXPECT_GT(black.relmse, 10.0);
    EXPECT_EQ(checked.certify(checked.check, uniform_image(checked.scene, std::nan(""))).points, 0);
    Checked dark(furnace(0.0F), 0);
    dark.look(1 << 10, 5);
    const CertifiedError right = dark.certify(dark.check, uniform_image(dark.scene, 1.0));
    EXPECT_NEAR(right.relmse, 0.0, 1e-9);
}

TEST(ErrorCheck, OrdersEndWhereTheImageEnds) {
    for (int bounces = 0; bounces <= 4; ++bounces) {
        Checked checked(furnace(0.5F), bounces);
        checked.look(1 << 15, 6);
        const CertifiedError found = checked.certify(checked.check, uniform_image(checked.scene, (1.0 - std::pow(0.5, bounces + 1)) / 0.5));
        EXPECT_NEAR(found.mean_bias, 0.0, 4.0 * found.mean_error + 1e-5) << bounces << " bounces";
    }
}

TEST(ErrorCheck, AgreesWithThePathTracer) {
    Checked checked(room_of_everything());
    for (std::uint64_t film = 7; film < 17; ++film) checked.look(1 << 14, film);
    const CertifiedError found = checked.certify(checked.check, truth(checked.scene, 1024, 3));
    EXPECT_NEAR(found.mean_bias, 0.0, 4.0 * found.mean_error);
    EXPECT_LT(found.mean_error, 0.01);
}

/// Where a lobe draws no direction a path ends: among rough metals many do.
TEST(ErrorCheck, AgreesWithThePathTracerAmongRoughMetals) {
    Scene scene = closed_room();
    for (SceneMaterial& m : scene.materials) {
        m.model = MATERIAL_CONDUCTOR;
        m.alpha = glm::vec2(0.8F);
        m.eta = glm::vec3(0.2F, 0.9F, 1.4F);
        m.k = glm::vec3(3.9F, 2.4F, 1.6F);
    }
    Checked checked(scene);
    for (std::uint64_t film = 1; film < 5; ++film) checked.look(1 << 14, film);
    const CertifiedError found = checked.certify(checked.check, truth(checked.scene, 512, 3));
    EXPECT_NEAR(found.mean_bias, 0.0, 4.0 * found.mean_error);
    EXPECT_LT(found.mean_error, 0.02);
}

/// An image that is off by a known amount, by noise or by a corner that is too bright: the interval holds it nearly always.
TEST(ErrorCheck, TheIntervalHoldsTheTruth) {
    Checked checked(closed_room());
    const std::vector<float> good = truth(checked.scene, 2048, 3), noisy = truth(checked.scene, 4, 4);
    std::vector<float> with_bias = good;
    const int width = checked.scene.sensor.width;
    for (std::size_t i = 0; i < with_bias.size(); ++i)
        if (static_cast<int>(i / 3) % width < width / 3) with_bias[i] *= 1.3F;
    const std::vector<float>& biased = with_bias;
    double mean = 0;
    for (const float v : good) mean += static_cast<double>(v) / static_cast<double>(good.size());
    for (const std::vector<float>* image : {&noisy, &biased}) {
        double expected = 0;
        for (std::size_t i = 0; i < good.size(); ++i) {
            const double x = static_cast<double>((*image)[i]), step = x - static_cast<double>(good[i]);
            expected += step * step / (x * x + 0.01 * mean * mean) / static_cast<double>(good.size());
        }
        int held = 0;
        constexpr int runs = 40;
        for (int run = 0; run < runs; ++run) {
            ErrorCheck fresh(checked.context);
            const auto seed = static_cast<std::uint64_t>(run);
            checked.look(fresh, 1 << 15, seed);
            const CertifiedError found = checked.certify(fresh, *image);
            if (std::abs(found.relmse - expected) <= interval_errors * found.standard_error) ++held;
        }
        EXPECT_GE(held, 34) << "of " << runs << ", true relMSE " << expected;
    }
}

TEST(ErrorCheck, BothSourcesAreJoined) {
    CertifiedError certified;
    EXPECT_EQ(join_errors(0.01, certified), 0.01) << "nothing was checked";
    certified.points = 100;
    certified.relmse = 0.5;
    certified.standard_error = 0.01;
    EXPECT_NEAR(join_errors(0.01, certified), 0.5, 0.01) << "a bias that stands out counts in full";
    certified.relmse = 0.02;
    EXPECT_LT(join_errors(0.01, certified), 0.02) << "noise of the check counts little";
    certified.relmse = 0.013;
    EXPECT_LT(join_errors(1e-4, certified), 2e-4) << "and least where it knows so much less than the passes";
    for (const double spread : {0.0, 1e-12, 1e-6, 1e-3}) {
        certified.relmse = spread + 0.05;
        EXPECT_GT(join_errors(spread, certified), 0.04) << "what stands out five times counts";
    }
    certified.relmse = -0.02;
    EXPECT_EQ(join_errors(0.01, certified), 0.01);
    EXPECT_EQ(join_errors(std::numeric_limits<double>::infinity(), certified), 0.01) << "one pass: what the check can tell";
}

}  // namespace
