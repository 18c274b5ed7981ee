// Film pencils fitted with their neighbours.
#include "kernels/lattice_test.h"
#include "reference/tolerances.h"
#include "surface/smooth_irradiance.h"

namespace {

using namespace pencil;
using namespace pencil::test;

constexpr float most_error = 0.7F;
constexpr float untouched = -7;

std::vector<float4> smooth(const MadeFilm& film, const std::vector<float4>& irradiance) {
    Kernels kernels = make_kernels();
    DeviceFilm on_film(film);
    on_film.pencils.irradiance.write(irradiance);
    Buffer<float4> fits(device(), std::vector<float4>(3 * film.pencils.size() + 3, float4(untouched)), "fits");
    smooth_irradiance(kernels, on_film.lattice, most_error, film.width, film.height, fits);
    return fits.read();
}

TEST(SmoothIrradiance, IsTheWeightedLeastSquaresFit) {
    int compared = 0, sloped = 0;
    for (const FilmCase& c : film_cases()) {
        MadeFilm film(c.width, c.height, c.coarsest, c.finest, 51);
        const std::vector<float4> irradiance = random_irradiance(film.random(), film.pencils.size());
        const std::vector<float4> got = smooth(film, irradiance);
        for (int pixel = 0; pixel < c.width * c.height; ++pixel) {
            if (film.at[static_cast<std::size_t>(pixel)] < 0) continue;
            const auto fit = 3 * static_cast<std::size_t>(film.at[static_cast<std::size_t>(pixel)]);
            const ref::Fit expected = ref::fit(film.lattice(), irradiance, pixel % c.width, pixel / c.width, most_error);
            if (expected.margin < tolerance::decision) continue;
            ++compared;
            const std::string what = "pencil of pixel " + std::to_string(pixel) + ", " + name(c);
            // Slopes in terms of their own size, and of the irradiance of at most 4 over a pixel of 0.05.
            const double slope = tolerance::fit * (80.0 + glm::length(expected.along_t) + glm::length(expected.along_b));
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(got[fit][k], expected.value[k], tolerance::fit * 4.0) << what << ", channel " << k;
                ASSERT_NEAR(got[fit + 1][k], expected.along_t[k], slope) << what << ", slope along t, channel " << k;
                ASSERT_NEAR(got[fit + 2][k], expected.along_b[k], slope) << what << ", slope along b, channel " << k;
            }
            sloped += glm::length(expected.along_t) > 0.1 ? 1 : 0;
        }
        for (std::size_t i = 3 * film.pencils.size(); i < got.size(); ++i) EXPECT_EQ(got[i], float4(untouched)) << "behind the last fit";
    }
    EXPECT_GT(compared, 400);
    EXPECT_GT(sloped, 300);
}

TEST(SmoothIrradiance, ConstantIrradianceStaysConstant) {
    const MadeFilm film(37, 23, 8, 2, 52);
    const std::vector<float4> fits = smooth(film, std::vector<float4>(film.pencils.size(), float4(2, 3, 4, 0)));
    for (std::size_t p = 0; p < film.pencils.size(); ++p) {
        expect_close(xyz(fits[3 * p]), dvec3(2, 3, 4), tolerance::fit, "value of pencil " + std::to_string(p));
        for (const std::size_t slope : {3 * p + 1, 3 * p + 2})  // in a pixel of 0.05
            EXPECT_LT(glm::length(xyz(fits[slope])) * 0.05, 4 * tolerance::fit) << "slope of pencil " << p;
    }
}

/// A plane whose irradiance is linear: values and slopes are those of the function, but for the hold on slopes.
TEST(SmoothIrradiance, LinearIrradianceOnAPlaneIsKept) {
    MadeFilm film(37, 23, 4, 4, 53);
    std::vector<float4> irradiance;
    const dvec3 gradient(0.7, 0.0, -0.4);
    for (SurfacePencil& p : film.pencils) {
        p.position = to_float4({p.position.x, 0, p.position.z}, 0.8);
        p.normal = p.facing = float4(0, 1, 0, 0);
        p.facing.w = p.position.w;
        std::fill(std::begin(p.horizon_x), std::end(p.horizon_x), 0.0F);
        std::fill(std::begin(p.horizon_y), std::end(p.horizon_y), 0.0F);
        irradiance.push_back(to_float4(dvec3(3.0 + glm::dot(gradient, xyz(p.position)))));
    }
    const std::vector<float4> fits = smooth(film, irradiance);
    const ref::TangentFrame frame({0, 1, 0});
    for (int pixel = 0; pixel < film.width * film.height; ++pixel) {
        if (film.at[static_cast<std::size_t>(pixel)] < 0) continue;
        const auto p = static_cast<std::size_t>(film.at[static_cast<std::size_t>(pixel)]);
        EXPECT_NEAR(fits[3 * p].x, irradiance[p].x, tolerance::held) << "pencil " << p;
        EXPECT_NEAR(fits[3 * p + 1].x, glm::dot(gradient, frame.t), tolerance::held) << "slope along t of pencil " << p;
        EXPECT_NEAR(fits[3 * p + 2].x, glm::dot(gradient, frame.b), tolerance::held) << "slope along b of pencil " << p;
    }
}

/// Pencils that no neighbour may stand for had no value in rooms that are a millionth of the scene: squares of squares of distances left the
/// range of floats.
TEST(SmoothIrradiance, SmallThingsAreFittedAsLargeOnes) {
    MadeFilm film(37, 23, 8, 2, 55);
    const std::vector<float4> irradiance = random_irradiance(film.random(), film.pencils.size());
    const std::vector<float4> large = smooth(film, irradiance);
    constexpr float scale = 0x1p-24F;
    for (SurfacePencil& p : film.pencils) {
        p.position *= scale;
        p.facing.w *= scale;
        for (float& h : p.horizon_x) h /= scale;
        for (float& h : p.horizon_y) h /= scale;
    }
    const std::vector<float4> small = smooth(film, irradiance);
    for (std::size_t p = 0; p < film.pencils.size(); ++p) {
        expect_close(xyz(small[3 * p]), xyz(large[3 * p]), 1e-6, "value of pencil " + std::to_string(p));
        for (const std::size_t slope : {3 * p + 1, 3 * p + 2})
            expect_close(dvec3(scale) * xyz(small[slope]), xyz(large[slope]), 1e-6, "slope of pencil " + std::to_string(p));
    }
}

TEST(SmoothIrradiance, PermutingPencilsChangesNothing) {
    MadeFilm film(37, 23, 8, 2, 54);
    const std::vector<int> order = shuffled(film.random(), film.pencils.size());
    const std::vector<float4> irradiance = random_irradiance(film.random(), film.pencils.size());
    std::vector<float4> turned;
    for (const int p : order) turned.push_back(irradiance[static_cast<std::size_t>(p)]);
    const std::vector<float4> straight = smooth(film, irradiance), permuted = smooth(renumbered(film, order), turned);
    for (std::size_t p = 0; p < order.size(); ++p)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(permuted[3 * p + k], straight[3 * static_cast<std::size_t>(order[p]) + k]) << "pencil " << order[p];
}

}  // namespace
