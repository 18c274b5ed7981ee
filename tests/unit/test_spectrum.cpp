// Spectra to linear sRGB: known whites, and the colours that the Cornell box scene was given.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "scene/formats/load_scene.h"
#include "scene/mitsuba/spectrum.h"

namespace pencil {
namespace {

constexpr double printed = 6e-6;  // half a unit of the scene file's last digit, and a little

void expect_near(glm::dvec3 value, glm::dvec3 expected, double tolerance) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(value[i], expected[i], tolerance) << "component " << i;
}

TEST(Spectrum, TablesGiveTheirPublishedSums) {
    glm::dvec3 white(0.0), equal(0.0);
    for (double w = 380.0; w <= 780.0; w += 1.0) {
        white += illuminant_d65(w) * cie_1931(w);
        equal += cie_1931(w);
    }
    EXPECT_NEAR(white.x / (white.x + white.y + white.z), 0.31271, 1e-4);  // D65, CIE 15
    EXPECT_NEAR(white.y / (white.x + white.y + white.z), 0.32902, 1e-4);
    EXPECT_NEAR(equal.y, 106.857, 0.01);
    EXPECT_NEAR(equal.x / equal.y, 1.0, 1e-3);  // illuminant E has equal X, Y and Z
    EXPECT_NEAR(equal.z / equal.y, 1.0, 1e-3);
}

TEST(Spectrum, ConstantReflectanceIsGrey) {
    expect_near(reflectance_to_rgb({{300, 900}, {1, 1}}), glm::dvec3(1.0), 1e-12);
    expect_near(reflectance_to_rgb({{300, 500, 900}, {0.25, 0.25, 0.25}}), glm::dvec3(0.25), 1e-12);
}

TEST(Spectrum, ConstantEmissionIsIlluminantE) {
    expect_near(emission_to_rgb({{300, 900}, {1, 1}}), {1.2048, 0.9483, 0.9091}, 5e-4);  // row sums of the XYZ to sRGB matrix
}

TEST(Spectrum, OutsideItsWavelengthsASpectrumIsZero) {
    expect_near(emission_to_rgb({{900, 1000}, {1, 1}}), glm::dvec3(0.0), 0.0);
    const glm::dvec3 green = emission_to_rgb({{520, 530}, {1, 1}});
    EXPECT_GT(green.y, 0.0);
    EXPECT_LT(green.x, 0.0);  // outside the gamut
}

/// The observer as sums of Gaussians with different widths on both sides (Wyman, Sloan, Shirley, Simple Analytic Approximations to the CIE
/// XYZ Color Matching Functions, Journal of Computer Graphics Techniques 2(2), 2013), within 1 % of the tables.
glm::dvec3 analytic_observer(double wavelength) {
    const auto lobe = [&](double height, double centre, double below, double above) {
        const double t = (wavelength - centre) / (wavelength < centre ? below : above);
        return height * std::exp(-0.5 * t * t);
    };
    return {lobe(1.056, 599.8, 37.9, 31.0) + lobe(0.362, 442.0, 16.0, 26.7) + lobe(-0.065, 501.1, 20.4, 26.2),
            lobe(0.821, 568.8, 46.9, 40.5) + lobe(0.286, 530.9, 16.3, 31.1),
            lobe(1.217, 437.0, 11.8, 36.0) + lobe(0.681, 459.0, 26.0, 13.8)};
}

TEST(Spectrum, LightOfTheCornellBoxByAnotherObserverAndMatrix) {
    glm::dvec3 xyz(0.0);
    double y = 0.0;
    for (double w = 380.0; w <= 780.0; w += 0.5) {
        const double power = w < 400 || w > 700 ? 0.0
                             : w < 500          ? 0.08 * (w - 400)
                             : w < 600          ? 8.0 + 0.076 * (w - 500)
                                                : 15.6 + 0.028 * (w - 600);
        xyz += power * analytic_observer(w);
        y += analytic_observer(w).y;
    }
    xyz /= y;
    // The matrix of IEC 61966-2-1.
    const glm::dvec3 rgb(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                         0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z);
    const glm::dvec3 ours = emission_to_rgb({{400, 500, 600, 700}, {0, 8, 15.6, 18.4}});
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], rgb[i], 0.01 * rgb[i]) << "component " << i;
}

TEST(Spectrum, TransferCurve) {
    EXPECT_DOUBLE_EQ(srgb_to_linear(0.0), 0.0);
    EXPECT_DOUBLE_EQ(srgb_to_linear(1.0), 1.0);
    EXPECT_NEAR(srgb_to_linear(0.5), 0.21404, 1e-5);
    EXPECT_NEAR(srgb_to_linear(0.04), 0.04 / 12.92, 1e-12);
}

TEST(Spectrum, CornellBoxSceneHoldsTheMeasuredColours) {
    std::ifstream file(std::string(PENCIL_SOURCE_DIR) + "/scenes/spectra/cornell-box.csv");
    SampledSpectrum white, green, red;
    double wavelength = 0, w = 0, g = 0, r = 0;
    for (std::string line; std::getline(file, line);) {
        if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &wavelength, &w, &g, &r) != 4) continue;
        for (SampledSpectrum* spectrum : {&white, &green, &red}) spectrum->wavelengths.push_back(wavelength);
        white.values.push_back(w);
        green.values.push_back(g);
        red.values.push_back(r);
    }
    ASSERT_EQ(white.values.size(), 76U);
    // The published renderings of other programs use illuminant E, which is what the emission function integrates.
    expect_near(emission_to_rgb(white), {0.885809, 0.698859, 0.666422}, 5e-4);
    expect_near(emission_to_rgb(green), {0.105421, 0.37798, 0.076425}, 5e-4);
    expect_near(emission_to_rgb(red), {0.570068, 0.0430135, 0.0443706}, 5e-4);

    const Scene scene = load_scene(std::string(PENCIL_SOURCE_DIR) + "/scenes/cornell-box.xml");
    for (const SceneMaterial& material : scene.materials) {
        if (material.id == "white") expect_near(material.albedo, reflectance_to_rgb(white), printed);
        if (material.id == "green") expect_near(material.albedo, reflectance_to_rgb(green), printed);
        if (material.id == "red") expect_near(material.albedo, reflectance_to_rgb(red), printed);
    }
    const glm::dvec3 light = emission_to_rgb({{400, 500, 600, 700}, {0, 8, 15.6, 18.4}});
    EXPECT_TRUE(scene.shapes.back().emits);
    expect_near(scene.shapes.back().radiance, light, printed);
}

}  // namespace
}  // namespace pencil
