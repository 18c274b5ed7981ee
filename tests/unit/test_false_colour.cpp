// False colours with a scale: colours that order values in grey, too, a round end, and a legend that names them.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/colour.h"
#include "image/false_colour.h"
#include "image/small_font.h"
#include "image/write_image.h"
#include "util/error.h"

namespace pencil {
namespace {

glm::dvec3 pixel(const Picture& picture, int x, int y) {
    const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

glm::dvec3 linear(double position) {
    const std::array<float, 3> shown = scale_colour(position);
    return {srgb_to_linear(shown[0]), srgb_to_linear(shown[1]), srgb_to_linear(shown[2])};
}

TEST(FalseColour, EverLighter) {
    double last = -1;
    for (int i = 0; i <= 100; ++i) {
        const double light = luminance(linear(i / 100.0));
        EXPECT_GT(light, last) << i;
        last = light;
    }
    EXPECT_EQ(scale_colour(-3), scale_colour(0));
    EXPECT_EQ(scale_colour(7), scale_colour(1));
}

TEST(FalseColour, TheScaleEndsAtARoundNumber) {
    std::vector<float> values(1000, 310.0F);
    values[0] = 1e6F;  // a single bright pixel does not decide
    EXPECT_DOUBLE_EQ(scale_end(values), 500);
    EXPECT_DOUBLE_EQ(scale_end({0.017F}), 0.02);
    EXPECT_DOUBLE_EQ(scale_end({1000.0F}), 1000);
    EXPECT_DOUBLE_EQ(scale_end({7.0F}), 10);
    EXPECT_DOUBLE_EQ(scale_end({0.0F, 0.0F}), 1);
    EXPECT_DOUBLE_EQ(scale_end({std::numeric_limits<float>::quiet_NaN()}), 1);
    EXPECT_DOUBLE_EQ(scale_end({}), 1);
}

TEST(FalseColour, PixelsAndLegend) {
    constexpr int width = 40, height = 200;
    std::vector<float> values(std::size_t(width) * height, 250.0F);
    values[0] = std::numeric_limits<float>::quiet_NaN();
    values[1] = 0;
    const Picture picture = false_colours(values, width, height, "lx");
    ASSERT_EQ(picture.height, height);
    ASSERT_GT(picture.width, width + text_width("500"));
    EXPECT_NEAR(pixel(picture, 0, 0).x, 1, 1e-6) << "undefined is red";
    EXPECT_NEAR(pixel(picture, 0, 0).y, 0, 1e-6);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(pixel(picture, 1, 0)[c], linear(0)[c], 1e-6);
        EXPECT_NEAR(pixel(picture, 20, 100)[c], linear(0.5)[c], 1e-6) << "half of 500";
    }
    // The bar holds the colours of the scale in their order, dark below.
    int bar = width;
    while (bar < picture.width && luminance(pixel(picture, bar, height - 12)) > 0.5) ++bar;
    ASSERT_LT(bar, picture.width) << "no bar";
    EXPECT_LT(luminance(pixel(picture, bar + 2, height - 12)), luminance(pixel(picture, bar + 2, height / 2)));
    EXPECT_LT(luminance(pixel(picture, bar + 2, height / 2)), luminance(pixel(picture, bar + 2, 30)));
}

/// Whether `text` stands in the picture with its upper left corner at (left, top): ink where it has dots, none beside them.
bool spells(const Picture& picture, int left, int top, const std::string& text) {
    std::vector<bool> dots(static_cast<std::size_t>(text_width(text) * glyph_height));
    draw_text(text, [&](int x, int y) { dots[static_cast<std::size_t>(y * text_width(text) + x)] = true; });
    for (int y = 0; y < glyph_height; ++y)
        for (int x = 0; x < text_width(text); ++x) {
            if (left + x >= picture.width || top + y >= picture.height) return false;
            const bool ink = luminance(pixel(picture, left + x, top + y)) == 0;
            if (ink != dots[static_cast<std::size_t>(y * text_width(text) + x)]) return false;
        }
    return true;
}

/// The rows in which `text` stands at this column.
std::vector<int> rows_of(const Picture& picture, int column, const std::string& text) {
    std::vector<int> rows;
    for (int y = 0; y + glyph_height <= picture.height; ++y)
        if (spells(picture, column, y, text)) rows.push_back(y);
    return rows;
}

/// The column where numbers begin: all of them are written from there to the right.
int column_of_numbers(const Picture& picture, int width, const std::string& last) {
    for (int x = width; x < picture.width; ++x)
        if (!rows_of(picture, x, last).empty()) return x;
    return -1;
}

TEST(FalseColour, TheLegendNamesItsEnds) {
    constexpr int width = 40, height = 200;
    const Picture picture = false_colours(std::vector<float>(std::size_t(width) * height, 250.0F), width, height, "lx");
    const int column = column_of_numbers(picture, width, "500");
    ASSERT_GE(column, 0) << "no number of the last colour";
    const std::vector<int> top = rows_of(picture, column, "500"), bottom = rows_of(picture, column, "0");
    ASSERT_EQ(top.size(), 1U);
    EXPECT_LT(top.front(), height / 4);
    ASSERT_EQ(bottom.size(), 1U);
    EXPECT_GT(bottom.front(), height * 3 / 4);
}

TEST(FalseColour, SmallPicturesHaveALegendToo) {
    const Picture picture = false_colours({3.0F}, 1, 1, "cd/m2");
    EXPECT_GE(picture.height, 90);
    EXPECT_EQ(picture.rgb.size(), std::size_t(3) * picture.width * picture.height);
}

TEST(FalseColour, EveryCharacterOfNumbersAndUnitsHasAGlyph) {
    for (const char c : std::string("0123456789.-+elxcd/m")) {
        int dots = 0;
        draw_text(std::string(1, c), [&](int x, int y) {
            ++dots;
            EXPECT_TRUE(x >= 0 && x < glyph_width && y >= 0 && y < glyph_height) << c;
        });
        EXPECT_GT(dots, 2) << c;
    }
    EXPECT_EQ(text_width("12"), glyph_step + glyph_width);
    EXPECT_EQ(text_width(""), 0);
}

TEST(FalseColour, NamesOfPngsChooseTheLayer) {
    EXPECT_EQ(layer_of_name("a/room.illuminance.png"), "illuminance");
    EXPECT_EQ(layer_of_name("room.luminance.PNG"), "luminance");
    EXPECT_EQ(layer_of_name("room.Illuminance.png"), "illuminance");
    EXPECT_EQ(photometric_word("room.ILLUMINANCE.exr"), "illuminance");
    EXPECT_EQ(layer_of_name("room.illuminance.exr"), "");
    EXPECT_EQ(layer_of_name("room.png"), "");
    EXPECT_EQ(layer_of_name("illuminance.png"), "");
    const std::vector<float> beauty(3, 0.5F);
    const LayeredImage image{1, 1, {{"", 3, beauty.data()}}};
    EXPECT_THROW(write_image("/tmp/pencil-never-written.illuminance.png", image), OutputError);
}

}  // namespace
}  // namespace pencil
