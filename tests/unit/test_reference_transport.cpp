// Density, transport, form factors and filters checked against closed forms and against the published study of the estimators.
#include <gtest/gtest.h>

#include "reference/density_ref.h"
#include "reference/film_ref.h"
#include "reference/form_factor_ref.h"
#include "reference/random.h"
#include "reference/transport_ref.h"

namespace {

using namespace pencil::ref;

constexpr double exact_transport = 1e-12;

std::vector<dvec3> wall(int axis, double at) {
    std::vector<dvec3> out;
    for (const dvec2& p : {dvec2(0, 0), dvec2(1, 0), dvec2(1, 1), dvec2(0, 1)}) {
        dvec3 corner;
        corner[axis] = at;
        corner[(axis + 1) % 3] = p.x;
        corner[(axis + 2) % 3] = p.y;
        out.push_back(corner);
    }
    return out;
}

TEST(FormFactor, WallsOfTheUnitBoxFillTheHemisphere) {
    const dvec3 up(0, 1, 0);
    for (const dvec3& x : {dvec3(0.5, 0, 0.5), dvec3(0.01, 0, 0.5), dvec3(0.02, 0, 0.02), dvec3(0.3, 0, 0.9)}) {
        double sum = polygon_irradiance(wall(1, 1.0), x, up);
        for (const int axis : {0, 2}) sum += polygon_irradiance(wall(axis, 0.0), x, up) + polygon_irradiance(wall(axis, 1.0), x, up);
        EXPECT_NEAR(sum, pi, exact_transport) << x.x << " " << x.z;
    }
}

TEST(FormFactor, ClosedFormsAgree) {
    const dvec3 up(0, 1, 0);
    EXPECT_NEAR(polygon_irradiance(wall(1, 1.0), {0.5, 0, 0.5}, up) / pi, 4.0 * parallel_corner_factor(0.5, 0.5, 1.0), exact_transport);
    EXPECT_NEAR(4.0 * parallel_corner_factor(0.5, 0.5, 1.0), 0.2394565, 1e-6);  // floor centre to ceiling of a cube
    for (const dvec2& p : {dvec2(0.5, 0.5), dvec2(0.2, 0.5), dvec2(0.05, 0.5), dvec2(0.01, 0.5), dvec2(0.02, 0.02)})
        EXPECT_NEAR(polygon_irradiance(wall(0, 0.0), {p.x, 0, p.y}, up), lit_wall_irradiance(p.x, p.y), exact_transport)
            << p.x << " " << p.y;
    EXPECT_NEAR(lit_wall_irradiance(1e-9, 0.5), pi / 2.0, 1e-6) << "at its foot a wall fills half the hemisphere";
}

TEST(FormFactor, AgreesWithNumericalIntegrationThroughTheHorizon) {
    // A tilted receiver: part of the wall lies below its horizon and must be cut off.
    const dvec3 x(0.3, 0.4, 0.2), normal = glm::normalize(dvec3(-0.2, 0.5, 1.0));
    double sum = 0.0;
    const int n = 2000;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const dvec3 d = dvec3(0.0, (i + 0.5) / n, (j + 0.5) / n) - x;
            const double r2 = glm::dot(d, d);
            sum += std::max(glm::dot(normal, d), 0.0) * std::max(-d.x, 0.0) / (r2 * r2);
        }
    }
    EXPECT_NEAR(polygon_irradiance(wall(0, 0.0), x, normal), sum / (n * n), 1e-5);
}

TEST(Density, ExponentFollowsTheNumberOfPencils) {
    EXPECT_EQ(lobe_exponent(0), 1.0);
    EXPECT_EQ(lobe_exponent(1), 4.0);  // log2(5) = 2.32
    EXPECT_EQ(lobe_exponent(128), 32.0);
    EXPECT_EQ(lobe_exponent(2048), 64.0);
    EXPECT_EQ(lobe_exponent(1 << 30), 512.0);
}

TEST(Density, CountsCoincidentPencils) {
    const std::vector<dvec3> directions{{0, 0, 1}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {0, 0, 1}};
    const std::vector<double> d = pencil_density(directions, {true, true, true, true, false}, 8.0);
    EXPECT_EQ(d, (std::vector<double>{2, 2, 1, 1, 0}));
}

TEST(Transport, ConsistentWeightsReproduceConstantRadiance) {
    Random random(5);
    std::vector<PencilView> views(20);
    for (PencilView& v : views) v = {dvec3(2.5), random.uniform(-0.5, 1.0), random.uniform(0.1, 9.0), random.uniform() < 0.8};
    EXPECT_NEAR(irradiance_consistent(views).x, 2.5 * pi, exact_transport);
    EXPECT_EQ(irradiance_consistent({}), dvec3(0.0));
    EXPECT_NEAR(irradiance_printed({{dvec3(1.0), 0.5, 3.0, true}}).x, pi, exact_transport) << "one pencil at 60 degrees: 2 pi L cos";
}

/// Relative bias and RMSE of both estimators at the floor's centre of the unit cube, 128 uniform centres, constant radiance and lit wall.
struct Study {
    double printed_bias = 0, wall_rmse = 0;
};
Study study(std::uint32_t seed) {
    const dvec3 x(0.5, 0, 0.5);
    const double wall_exact = lit_wall_irradiance(0.5, 0.5);
    const int trials = 200;
    Random random(seed);
    Study out;
    for (int trial = 0; trial < trials; ++trial) {
        std::vector<dvec3> directions;
        for (int i = 0; i < 128; ++i) directions.push_back(glm::normalize(random.in_box(0, 1) - x));
        const std::vector<double> d = pencil_density(directions, std::vector<bool>(128, true), 32.0);
        std::vector<PencilView> constant, lit;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const dvec3& w = directions[i];
            // Seen from x along w, the wall x = 0 is met first if its distance is the smallest.
            const double t = -0.5 / w.x, top = 1.0 / w.y, side = 0.5 / std::abs(w.z);
            const bool is_lit = w.x < 0.0 && t < top && t < side;
            constant.push_back({dvec3(1.0), w.y, d[i], true});
            lit.push_back({dvec3(is_lit ? 1.0 : 0.0), w.y, d[i], true});
        }
        out.printed_bias += (irradiance_printed(constant).x / pi - 1.0) / trials;
        const double error = irradiance_consistent(lit).x / wall_exact - 1.0;
        out.wall_rmse += error * error / trials;
    }
    out.wall_rmse = std::sqrt(out.wall_rmse);
    return out;
}

TEST(Transport, ReproducesTheEstimatorStudy) {
    const Study s = study(6);
    EXPECT_NEAR(s.printed_bias, 0.52, 0.04) << "printed normaliser, constant radiance, beta 32";
    EXPECT_NEAR(s.wall_rmse, 0.141, 0.02) << "consistent weights, lit wall, beta 32";
}

TEST(Film, FiltersAtKnownPoints) {
    EXPECT_EQ(box_filter(0.5), 1.0);
    EXPECT_EQ(box_filter(0.51), 0.0);
    EXPECT_EQ(tent_filter(0.25), 0.75);
    EXPECT_NEAR(gaussian_filter(0.0), 1.0 - std::exp(-8.0), exact_transport);
    EXPECT_EQ(gaussian_filter(2.0), 0.0);
    EXPECT_NEAR(mitchell_filter(0.0), 8.0 / 9.0, exact_transport);
    EXPECT_NEAR(mitchell_filter(1.0), 1.0 / 18.0, exact_transport);
    EXPECT_NEAR(catmullrom_filter(0.5), 0.5625, exact_transport);
    EXPECT_NEAR(catmullrom_filter(1.5), -0.0625, exact_transport);
    EXPECT_EQ(lanczos_filter(0.0), 1.0);
    EXPECT_NEAR(lanczos_filter(1.0), 0.0, exact_transport);
    for (const double x : {-0.5, -0.3, 0.0, 0.4}) {  // the cubic filters are partitions of unity
        double mitchell = 0.0, catmullrom = 0.0;
        for (int k = -3; k <= 3; ++k) {
            mitchell += mitchell_filter(x + k);
            catmullrom += catmullrom_filter(x + k);
        }
        EXPECT_NEAR(mitchell, 1.0, exact_transport);
        EXPECT_NEAR(catmullrom, 1.0, exact_transport);
    }
}

}  // namespace
