// Images against each other: which layers are a pair, what is said of them, and the picture of the difference.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "compare/compare_images.h"
#include "compare/difference_image.h"
#include "compare/image_layers.h"
#include "options/layer.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

Image image_with(std::vector<std::string> channels, std::vector<float> pixels) {
    Image image;
    image.height = 1;
    image.width = static_cast<int>(pixels.size() / channels.size());
    image.channels = std::move(channels);
    image.pixels = std::move(pixels);
    return image;
}

TEST(ImageLayers, ChannelsAreGroupedAndOrdered) {
    const Image image = image_with({"A", "B", "G", "R", "a.b.R", "depth.Z", "direct.B", "direct.G", "direct.R", "direct.A"},
                                   {9, 3, 2, 1, 4, 5, 8, 7, 6, 9});
    const std::vector<NamedLayer> layers = split_layers(image);
    ASSERT_EQ(layers.size(), 4U);
    EXPECT_EQ(layers[0].name, "beauty");
    EXPECT_EQ(layers[0].channels, (std::vector<std::string>{"R", "G", "B"}));
    EXPECT_EQ(layers[0].pixels, (std::vector<float>{1, 2, 3}));
    EXPECT_EQ(layers[1].name, "a.b");
    EXPECT_EQ(layers[2].pixels, std::vector<float>{5});
    EXPECT_EQ(layers[3].pixels, (std::vector<float>{6, 7, 8}));
}

TEST(ImageLayers, DisplayValuesBecomeLinear) {
    Image image = image_with({"R", "G", "B"}, {0, 0.5F, 1});
    image.display = true;
    EXPECT_NEAR(split_layers(image)[0].pixels[1], 0.2140411, 1e-6);
}

TEST(CompareImages, LayersThatBothHave) {
    const Image a = image_with({"R", "G", "B", "direct.R", "direct.G", "direct.B", "depth.Z"}, {1, 1, 1, 2, 2, 2, 3});
    const Image b = image_with({"R", "G", "B", "A", "direct.R", "direct.G", "direct.B", "bounce2.R"}, {1, 1, 1, 1, 1, 1, 1, 1});
    const Comparison result = compare_images(a, b, "a.exr", "b.exr");
    ASSERT_EQ(result.layers.size(), 2U);
    EXPECT_EQ(result.layers[0].metrics.rmse, 0);
    EXPECT_EQ(result.layers[1].name, "direct");
    EXPECT_EQ(result.layers[1].metrics.rmse, 1);
    EXPECT_EQ(result.only_in_image, std::vector<std::string>{"depth"});
    EXPECT_EQ(result.only_in_reference, std::vector<std::string>{"bounce2"});
    EXPECT_THROW(compare_images(image_with({"x.R"}, {1}), image_with({"y.R"}, {1}), "a", "b"), SceneError);
}

TEST(CompareImages, TailsOfOtherOrdersAreNoPair) {
    const Image render = image_with({"bounce10.R", tail_layer(11) + ".R"}, {1, 2});
    const Image reference = image_with({"bounce10.R", "bounce11.R", tail_layer(16) + ".R"}, {1, 1, 1});
    const Comparison result = compare_images(render, reference, "a.exr", "b.exr");
    ASSERT_EQ(result.layers.size(), 1U);
    EXPECT_EQ(result.layers[0].name, "bounce10");
    EXPECT_EQ(result.only_in_image, std::vector<std::string>{"tail11"});
    EXPECT_EQ(result.only_in_reference, (std::vector<std::string>{"bounce11", "tail16"}));
    EXPECT_EQ(compare_images(reference, reference, "b", "b").layers.size(), 3U);
    EXPECT_TRUE(is_light("tail16"));
}

TEST(CompareImages, SizesThatDifferAreBothNamed) {
    try {
        compare_images(image_with({"R", "G", "B"}, {1, 1, 1}), image_with({"R", "G", "B"}, {1, 1, 1, 1, 1, 1}), "a.exr", "b.exr");
        FAIL() << "accepted";
    } catch (const SceneError& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("1x1"), std::string::npos) << text;
        EXPECT_NE(text.find("2x1"), std::string::npos) << text;
    }
}

TEST(CompareImages, NonFiniteValuesAreCountedAndPlaced) {
    const Image a = image_with({"R", "G", "B"}, {1, 1, 1, 1, nan, nan}), b = image_with({"R", "G", "B"}, {1, 1, 1, 1, 1, 1});
    const LayerComparison layer = compare_images(a, b, "a", "b").layers[0];
    EXPECT_EQ(layer.image.values, 2U);
    EXPECT_EQ(layer.image.channel, "G");
    EXPECT_EQ(layer.image.x, 1);
    EXPECT_EQ(layer.reference.values, 0U);
    EXPECT_EQ(layer.metrics.excluded, 1U);
}

TEST(CompareImages, AnotherSceneIsAWarning) {
    Image a = image_with({"R", "G", "B"}, {1, 1, 1}), b = a;
    a.metadata = {{"pencil:scene", "room.xml"}, {"pencil:sceneFingerprint", "12"}};
    EXPECT_TRUE(compare_images(a, b, "a", "b").warnings.empty()) << "files of other programs name no scene";
    b.metadata = {{"pencil:scene", "copy of room.xml"}, {"pencil:sceneFingerprint", "12"}};
    EXPECT_TRUE(compare_images(a, b, "a", "b").warnings.empty());
    b.metadata["pencil:sceneFingerprint"] = "13";
    ASSERT_EQ(compare_images(a, b, "a", "b").warnings.size(), 1U);
    b.metadata.erase("pencil:sceneFingerprint");
    EXPECT_EQ(compare_images(a, b, "a", "b").warnings.size(), 1U);
    b.metadata = {{"pencil:interrupted", "1"}};
    EXPECT_EQ(compare_images(a, b, "a", "b").warnings.size(), 1U);
}

TEST(DifferenceImage, SignAndSizeOfTheDifference) {
    const std::vector<float> x{2, 2, 2, 0.5F, 0.5F, 0.5F, 1, 1, 1, nan, 1, 1}, r(12, 1.0F);
    const std::vector<float> d = relative_difference(x.data(), r.data(), 4);
    EXPECT_NEAR(d[0], 1 / std::sqrt(1.01), 1e-6);
    EXPECT_NEAR(d[1], -0.5 / std::sqrt(1.01), 1e-6);
    EXPECT_EQ(d[2], 0);
    EXPECT_TRUE(std::isnan(d[3]));
    EXPECT_EQ(difference_scale(d), 1);
    EXPECT_EQ(difference_scale({0.013F, -0.02F}), 0.02);
    EXPECT_EQ(difference_scale({-0.4F}), 0.5);
    EXPECT_EQ(difference_scale({}), 1);

    const std::vector<float> colours = false_colour(d, 1);
    EXPECT_GT(colours[0], 2 * colours[2]) << "too bright is red";
    EXPECT_GT(colours[5], 2 * colours[3]) << "too dark is blue";
    EXPECT_GT(colours[6], 0.9) << "no difference is white";
    EXPECT_EQ(colours[6], colours[8]);
    EXPECT_LT(colours[11], 0.1) << "undefined is yellow";
}

}  // namespace
}  // namespace pencil
