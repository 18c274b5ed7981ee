// Measures of error against values computed by hand, published L*a*b* values and OpenImageIO's own comparison.
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "compare/lab.h"
#include "compare/metrics.h"
#include "image/write_image.h"

namespace pencil {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

Metrics measure_rgb(const std::vector<float>& x, const std::vector<float>& r, const std::optional<double>& exposure = {}) {
    return measure({x.data(), r.data(), x.size() / 3, 3}, exposure);
}

TEST(Metrics, KnownValuesOfTwoPixels) {
    const std::vector<float> x{1, 2, 3, 0, 0, 1}, r{1, 1, 1, 2, 0, 1};
    const Metrics m = measure_rgb(x, r);
    EXPECT_EQ(m.pixels, 2U);
    // Squares of differences: 0 1 4 4 0 0; mean(r) = 1, so that every denominator is r^2 + 0.01.
    EXPECT_NEAR(m.rmse, std::sqrt(9.0 / 6), 1e-12);
    EXPECT_NEAR(m.rel_mse, (1 / 1.01 + 4 / 1.01 + 4 / 4.01) / 6, 1e-12);
    EXPECT_NEAR(m.mean_ratio, 7.0 / 6, 1e-12);
    EXPECT_NEAR(m.psnr, 10 * std::log10(6.0 / 9), 1e-12);
    EXPECT_FALSE(m.lab_rms.has_value());
}

TEST(Metrics, TheReferenceDecidesTheRelativeError) {
    const std::vector<float> a{2, 2, 2}, b{1, 1, 1};
    EXPECT_NEAR(measure_rgb(a, b).rel_mse, 1 / 1.01, 1e-12);
    EXPECT_NEAR(measure_rgb(b, a).rel_mse, 1 / (4 * 1.01), 1e-12);
}

TEST(Metrics, AnImageScaledByTwoPercent) {
    std::vector<float> r(300), x(300);
    std::iota(r.begin(), r.end(), 1000.0F);  // almost constant: r^2 is close to mean(r)^2
    std::transform(r.begin(), r.end(), x.begin(), [](float v) { return 1.02F * v; });
    const Metrics m = measure_rgb(x, r);
    EXPECT_NEAR(m.mean_ratio, 1.02, 1e-6);
    EXPECT_NEAR(std::sqrt(m.rel_mse), 0.02 / std::sqrt(1.01), 1e-5);
}

TEST(Metrics, EqualImages) {
    const std::vector<float> x{1, 2, 3};
    const Metrics m = measure_rgb(x, x, 1.0);
    EXPECT_EQ(m.rmse, 0);
    EXPECT_EQ(m.rel_mse, 0);
    EXPECT_EQ(m.mean_ratio, 1);
    EXPECT_EQ(m.psnr, std::numeric_limits<double>::infinity());
    EXPECT_EQ(m.lab_rms, 0);
}

TEST(Metrics, UndefinedIsNotANumber) {
    const std::vector<float> x{1, 1, 1}, black{0, 0, 0};
    EXPECT_TRUE(std::isnan(measure_rgb(x, black).rel_mse));
    EXPECT_TRUE(std::isnan(measure_rgb(x, black).mean_ratio));
    EXPECT_EQ(measure_rgb(x, black).rmse, 1);
    const std::vector<float> hole{not_a_number, 1, 1};
    EXPECT_TRUE(std::isnan(measure_rgb(hole, x).rmse));
    EXPECT_EQ(undefined_reason(measure_rgb(x, black)), "the mean of the reference is 0");
    EXPECT_EQ(undefined_reason(measure_rgb(hole, x)), "no pixel is finite in both images");
    EXPECT_EQ(undefined_reason(measure_rgb(x, x)), "");
}

TEST(Metrics, BlackIsEqualToBlack) {
    const std::vector<float> black{0, 0, 0}, signs{0, -0.0F, 0}, balanced{-1, 0, 1};  // the last: a normal's mean may be 0, too
    for (const auto& [x, r] : {std::pair(black, black), std::pair(signs, black), std::pair(balanced, balanced)}) {
        const Metrics m = measure_rgb(x, r, 1.0);
        EXPECT_EQ(m.rel_mse, 0);
        EXPECT_EQ(m.mean_ratio, 1);
        EXPECT_EQ(m.lab_rms, 0);
        EXPECT_EQ(undefined_reason(m), "");
    }
}

TEST(Metrics, PixelsThatAreNotFiniteDoNotCount) {
    const float inf = std::numeric_limits<float>::infinity();
    const std::vector<float> x{1, 2, 3, not_a_number, 0, 0, 5, 5, 5, 0, 0, 1}, r{1, 1, 1, 1, 1, 1, 1, -inf, 1, 2, 0, 1};
    const Metrics m = measure_rgb(x, r, 1.0), clean = measure_rgb({1, 2, 3, 0, 0, 1}, {1, 1, 1, 2, 0, 1}, 1.0);
    EXPECT_EQ(m.pixels, 2U);
    EXPECT_EQ(m.excluded, 2U);
    EXPECT_EQ(m.rmse, clean.rmse);
    EXPECT_EQ(m.rel_mse, clean.rel_mse);
    EXPECT_EQ(m.mean_ratio, clean.mean_ratio);
    EXPECT_EQ(m.lab_rms, clean.lab_rms);
}

TEST(Metrics, AgreeWithOpenImageIO) {
    const int width = 37, height = 19;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> uniform(0, 1);  // OpenImageIO's peak is the largest value of both images, but at least 1
    std::vector<float> x(std::size_t(width) * height * 3), r(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        r[i] = uniform(random);
        x[i] = r[i] * (0.8F + 0.2F * uniform(random));
    }
    const OIIO::ImageSpec spec(width, height, 3, OIIO::TypeDesc::FLOAT);
    const OIIO::ImageBufAlgo::CompareResults theirs =
        OIIO::ImageBufAlgo::compare(OIIO::ImageBuf(spec, x.data()), OIIO::ImageBuf(spec, r.data()), 1e-30F, 1e-30F);
    const Metrics ours = measure_rgb(x, r);
    EXPECT_NEAR(ours.rmse, theirs.rms_error, 1e-6 * theirs.rms_error);
    EXPECT_NEAR(ours.psnr, theirs.PSNR, 1e-4);
}

/// sRGB display values with the L*a*b* that B. Lindbloom's calculator and the CIE formulas give for them (D65, 2 degrees).
struct KnownLab {
    glm::dvec3 srgb, lab;
};

TEST(Lab, PublishedValues) {
    const std::vector<KnownLab> known{{{255, 255, 255}, {100, 0, 0}},
                                      {{0, 0, 0}, {0, 0, 0}},
                                      {{255, 0, 0}, {53.2408, 80.0925, 67.2032}},
                                      {{0, 255, 0}, {87.7347, -86.1827, 83.1793}},
                                      {{0, 0, 255}, {32.2970, 79.1875, -107.8602}},
                                      {{255, 255, 0}, {97.1393, -21.5537, 94.4780}},
                                      {{119, 119, 119}, {50.0344, 0, 0}}};
    for (const KnownLab& colour : known) {
        glm::dvec3 linear;
        for (int c = 0; c < 3; ++c) linear[c] = srgb_to_linear(static_cast<float>(colour.srgb[c] / 255));
        const glm::dvec3 lab = linear_srgb_to_lab(linear);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(lab[c], colour.lab[c], 0.02) << colour.srgb.x << " " << colour.srgb.y << " " << colour.srgb.z << " " << c;
    }
}

TEST(Lab, DarkColoursAreOnTheLinearPart) {
    // CIE 15:2004: L* = 903.2963 Y below Y = (6/29)^3.
    EXPECT_NEAR(linear_srgb_to_lab(glm::dvec3(0.001)).x, 0.9032963, 1e-6);
}

TEST(Lab, RmsOfDisplayedColours) {
    // Red against black in one of four pixels: dE^2 = L^2 + a^2 + b^2, averaged over the four.
    std::vector<float> x(12, 0.0F), r(12, 0.0F);
    x[3] = 0.5F;
    const double expected = std::sqrt((53.2408 * 53.2408 + 80.0925 * 80.0925 + 67.2032 * 67.2032) / 4);
    EXPECT_NEAR(*measure_rgb(x, r, 2.0).lab_rms, expected, 0.02);
    // What is displayed white in both does not differ.
    std::vector<float> bright(12, 7.0F), brighter(12, 9.0F);
    EXPECT_EQ(measure_rgb(bright, brighter, 1.0).lab_rms, 0);
}

TEST(Exposure, BringsTheMedianOfWhatIsLitToMiddleGrey) {
    const std::vector<float> rgb{0, 0, 0, 0.1F, 0.1F, 0.1F, 0.4F, 0.4F, 0.4F, 90, 90, 90, not_a_number, 1, 1, 0, 0, 0};
    EXPECT_NEAR(exposure_of(rgb.data(), 6), 0.18 / 0.4, 1e-6);
    EXPECT_EQ(exposure_of(rgb.data(), 1), 1);
}

}  // namespace
}  // namespace pencil
