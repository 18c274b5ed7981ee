// Values of textures between and beyond their texels.
#include <gtest/gtest.h>

#include "reference_renderer/test_images.h"
#include "scene/texture_lookup.h"

namespace {

using namespace pencil;
using namespace pencil::test;

TEST(Textures, WrapsAndFilters) {
    Texture t = bitmap(2, 2, {0, 1, 2, 3});
    const auto at = [&](float u, float v) { return look_up(t, {u, v}, glm::vec3(0.0F)).x; };
    EXPECT_FLOAT_EQ(at(0.25F, 0.25F), 0.0F);
    EXPECT_FLOAT_EQ(at(0.75F, 0.25F), 1.0F);
    EXPECT_FLOAT_EQ(at(0.25F, 0.75F), 2.0F);  // the second row
    EXPECT_FLOAT_EQ(at(0.5F, 0.5F), 1.5F);
    EXPECT_FLOAT_EQ(at(0.0F, 0.25F), 0.5F);  // half of the last column
    EXPECT_FLOAT_EQ(at(-0.75F, 2.25F), 0.0F);
    t.wrap_u = Texture::Wrap::clamp;
    EXPECT_FLOAT_EQ(at(-5.0F, 0.25F), 0.0F);
    EXPECT_FLOAT_EQ(at(5.0F, 0.25F), 1.0F);
    t.wrap_u = Texture::Wrap::mirror;
    EXPECT_FLOAT_EQ(at(-0.25F, 0.25F), 0.0F);
    EXPECT_FLOAT_EQ(at(1.25F, 0.25F), 1.0F);
    EXPECT_FLOAT_EQ(at(1.75F, 0.25F), 0.0F);
    t.nearest = true;
    EXPECT_FLOAT_EQ(at(0.49F, 0.51F), 2.0F);
    t = bitmap(2, 2, {0, 1, 2, 3});
    t.to_uv = glm::dmat3(0, 1, 0, 1, 0, 0, 0, 0, 1);  // u and v change places
    EXPECT_FLOAT_EQ(at(0.25F, 0.75F), 1.0F);
    const glm::vec2 slope = look_up_slope(t, {0.5F, 0.5F});
    EXPECT_NEAR(slope.x, 4.0F, 1e-5F);  // two a row, and half a unit from row to row
    EXPECT_NEAR(slope.y, 2.0F, 1e-5F);
    EXPECT_FLOAT_EQ(look_up(t, {0.1F, 0.1F}, glm::vec3(0.0F)).w, 0.5F);
    EXPECT_FLOAT_EQ(mean_colour(t).x, 1.5F);
}

TEST(Textures, SquaresAndColoursOfVertices) {
    Texture t;
    t.kind = Texture::Kind::checkerboard;
    t.colours[0] = glm::vec3(1.0F);
    t.colours[1] = glm::vec3(0.0F);
    const auto at = [&](float u, float v) { return look_up(t, {u, v}, {0.1F, 0.2F, 0.3F}).x; };
    EXPECT_EQ(at(0.2F, 0.3F), 1.0F);
    EXPECT_EQ(at(0.7F, 0.3F), 0.0F);
    EXPECT_EQ(at(0.7F, 0.8F), 1.0F);
    EXPECT_EQ(at(-0.2F, 0.3F), 0.0F);
    t.kind = Texture::Kind::vertex_colours;
    EXPECT_EQ(at(0.0F, 0.0F), 0.1F);
}

}  // namespace
