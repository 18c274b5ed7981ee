// The path tracer against closed forms, to three standard errors of its own estimate.
#include "reference_renderer/traced.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(KnownAnswers, LitWall) {
    for (const auto& [x, z] : {std::pair{0.5, 0.5}, {0.2, 0.5}, {0.05, 0.5}, {0.01, 0.5}, {0.02, 0.02}}) {
        Scene scene = lit_wall_box();
        look_at(scene, {x, 0.1, z}, {x, 0, z}, {0, 0, 1}, 0.2, 8, 8);  // pixels of 4e-5 about the place
        expect_mean(trace(scene, 1024, 2), ref::lit_wall_irradiance(x, z) / ref::pi, 2e-3,
                    "at " + std::to_string(x) + ", " + std::to_string(z));
    }
}

TEST(KnownAnswers, PolygonsByLambertsFormula) {
    for (const Luminaire& luminaire : luminaires())
        expect_mean(trace(luminaire_scene(luminaire), 1024), luminaire_answer(luminaire), 5e-3, luminaire.name);
}

TEST(KnownAnswers, PointLightOverAPlane) {
    const dvec3 light(0.2, 0.8, -0.3);
    for (const auto& [x, z] : {std::pair{0.2, -0.3}, {-0.5, 0.4}, {1.5, 1.2}}) {
        Scene scene;
        add_quad(scene, "floor", {-2, 0, -2}, {0, 0, 4}, {4, 0, 0}, {glm::vec3(0.75F), glm::vec3(0.0F), false});
        scene.point_lights.push_back({light, glm::vec3(3.0F)});
        look_at(scene, {x, 0.1, z}, {x, 0, z}, {0, 0, 1}, 0.2, 8, 8);
        const dvec3 to_light = light - dvec3(x, 0, z);
        const double r = glm::length(to_light);
        expect_mean(trace(scene, 64), 0.75 / ref::pi * 3.0 * to_light.y / (r * r * r), 1e-4, "at " + std::to_string(x));
    }
}

TEST(KnownAnswers, SphereWithAPointLightAtItsCentre) {
    const double albedo = 0.75, direct = albedo / ref::pi * 3.0 / 4.0;  // E = I / r^2, the same everywhere, and so is what is reflected
    Scene scene;
    add_shape(scene, "sphere", inward_sphere(2.0, 180), {glm::vec3(0.75F), glm::vec3(0.0F), false});
    scene.point_lights.push_back({dvec3(0.0), glm::vec3(3.0F)});
    look_at(scene, {0.5, 0.3, -0.4}, {2, -0.2, 1}, {0, 1, 0}, 80.0, 24, 24);
    expect_mean(trace(scene, 256), direct / (1.0 - albedo), 2e-3, "all orders");
    double series = 0;
    for (int depth = 2; depth <= 5; ++depth) {
        series += direct * std::pow(albedo, depth - 2);
        // Facets of one degree lie up to 4e-5 of the radius nearer to the light.
        const Estimate e = mean_of_image(trace(scene, 64, depth));
        EXPECT_NEAR(e.mean, series, 3.0 * e.error + 1e-4 * series) << "depth " << depth;
    }
}

TEST(KnownAnswers, FurnaceOrderByOrder) {
    for (const float albedo : {0.5F, 0.8F}) {
        const double a = albedo;
        for (int depth = 1; depth <= 6; ++depth) {
            expect_mean(trace(furnace(albedo), 64, depth), (1.0 - std::pow(a, depth)) / (1.0 - a), 2e-3,
                        "albedo " + std::to_string(a) + ", depth " + std::to_string(depth));
        }
        expect_mean(trace(furnace(albedo), 256), 1.0 / (1.0 - a), 2e-3, "albedo " + std::to_string(a));
    }
}

/// Long paths: weights must stay bounded, or a few paths hold all the light and most renders are too dark.
TEST(KnownAnswers, FurnaceOfBrightWalls) {
    for (const float albedo : {0.97F, 0.99F, 0.999F}) {
        const double a = albedo;
        expect_mean(trace(furnace(albedo), albedo > 0.995F ? 4 : 16), 1.0 / (1.0 - a), 2e-2, "albedo " + std::to_string(a));
    }
}

TEST(KnownAnswers, FurnaceLayersArePowersOfTheAlbedo) {
    ReferenceOptions options;
    options.spp = 256;
    options.bounces = true;
    const ReferenceResult result = trace_paths(furnace(0.5F), options);
    double rest = 1.0;
    for (int order = 0; order <= 8; ++order) {
        const Layer& image = layer(result.layers, order == 0 ? "emission" : order == 1 ? "direct" : "bounce" + std::to_string(order));
        double sum = 0, squares = 0;
        const auto n = static_cast<double>(pixel_count(image));
        for (std::size_t i = 0; i < pixel_count(image); ++i) {
            sum += pixel(image, i).x;
            squares += pixel(image, i).x * pixel(image, i).x;
        }
        const double error = std::sqrt(std::max(squares / n - sum * sum / (n * n), 0.0) / n);
        EXPECT_NEAR(sum / n, rest, 3.0 * error + float_rounding) << "order " << order;
        rest *= 0.5;
    }
    // All layers of light make up the beauty.
    for (std::size_t i = 0; i < pixel_count(result.layers[0]); ++i) {
        double sum = 0;
        for (std::size_t k = 1; k < result.layers.size(); ++k) sum += pixel(result.layers[k], i).x;
        ASSERT_NEAR(sum, pixel(result.layers[0], i).x, float_rounding * sum) << "pixel " << i;
    }
}

/// DESIGN of the test: E = flux / (S (1 - albedo)) is the mean over all walls, and here one wall stands for all.
TEST(KnownAnswers, Cie171Test58) {
    expect_mean(trace(cie_cube(1.0), 256, 2), cie_cube_answer(0.0) / ref::pi, 1e-3, "direct light, as with black walls");
    for (const double albedo : {0.2, 0.5, 0.8, 0.9, 0.95})
        expect_mean(trace(cie_cube(albedo), 256), albedo / ref::pi * cie_cube_answer(albedo), 3e-3, "albedo " + std::to_string(albedo));
}

TEST(KnownAnswers, NoLightThroughSheetsAndWalls) {
    for (const double thickness : {0.0, 0.004}) {
        for (const bool area : {false, true}) {
            SCOPED_TRACE(std::string(area ? "area" : "point") + " light, thickness " + std::to_string(thickness));
            const ReferenceResult dark = trace(two_rooms(thickness, area), 256);
            EXPECT_GT(dark.rays, dark.paths) << "paths go on in the dark room";
            expect_zero(layer(dark.layers, ""));
            Scene lit = two_rooms(thickness, area);
            look_at(lit, {0.1, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 90.0, 8, 8);
            EXPECT_GT(mean_of_image(trace(lit, 4)).mean, 0.1);
        }
    }
}

}  // namespace
