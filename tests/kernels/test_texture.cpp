// Textures on the device are the path tracer's: filters, ways to go on beyond the edges, transforms, checkerboards, colours of vertices.
#include <glm/gtc/packing.hpp>

#include "kernels/kernel_test.h"
#include "pencils/material_rows.h"
#include "scene/texture_lookup.h"

namespace {

using namespace pencil;
using namespace pencil::test;

Texture random_bitmap(Random& random, int width, int height) {
    Texture texture;
    texture.width = width;
    texture.height = height;
    for (int i = 0; i < width * height; ++i)
        texture.texels.push_back(glm::packHalf(glm::vec4(random.uniform(), random.uniform(), 8.0 * random.uniform(), random.uniform())));
    return texture;
}

/// By kernel texture_values or texture_slopes.
std::vector<float4> values(const Scene& scene, int texture, const std::vector<float4>& points, const char* kernel = "texture_values") {
    std::vector<std::uint64_t> texels;
    const std::vector<TextureRow> rows = flatten_textures(scene, texels);
    if (texels.empty()) texels.push_back(0);
    ProgramCache programs(device());
    Buffer<float4> found(device(), points.size(), "values");
    programs.kernel(kernel, PENCIL_SOURCE_DIR "/tests/kernels/test_texture.cl")
        .args(Buffer<TextureRow>(device(), rows, "textures"), texture, Buffer<std::uint64_t>(device(), texels, "texels"),
              Buffer<float4>(device(), points, "points"), static_cast<int>(points.size()), found)
        .run(points.size(), "texture values");
    return found.read();
}

TEST(TextureKernel, IsThePathTracers) {
    Random random(21);
    Scene scene;
    for (const Texture::Wrap wrap : {Texture::Wrap::repeat, Texture::Wrap::mirror, Texture::Wrap::clamp})
        for (const bool nearest : {false, true}) {
            scene.textures.push_back(random_bitmap(random, 7, 4));
            scene.textures.back().wrap_u = wrap;
            scene.textures.back().wrap_v = Texture::Wrap::mirror;
            scene.textures.back().nearest = nearest;
        }
    scene.textures.back().to_uv = glm::dmat3(2.0, 0.5, 0.0, -0.25, 1.5, 0.0, 0.3, -0.2, 1.0);
    scene.textures.push_back(random_bitmap(random, 1, 1));
    Texture squares;
    squares.kind = Texture::Kind::checkerboard;
    squares.colours[0] = glm::vec3(0.1F, 0.2F, 0.3F);
    squares.colours[1] = glm::vec3(0.9F, 0.8F, 0.7F);
    squares.to_uv = glm::dmat3(3.0, 0.0, 0.0, 0.0, 5.0, 0.0, 0.1, 0.2, 1.0);
    scene.textures.push_back(squares);
    std::vector<float4> points;
    for (int i = 0; i < 2000; ++i) points.emplace_back(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), 0, 0);
    for (std::size_t t = 0; t < scene.textures.size(); ++t) {
        const std::vector<float4> found = values(scene, static_cast<int>(t), points);
        int different = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::vec4 expected = look_up(scene.textures[t], glm::vec2(points[i]), glm::vec3(0.0F));
            const bool close = glm::distance(glm::vec4(found[i]), expected) < 1e-4F;
            different += close ? 0 : 1;
            const bool smooth = scene.textures[t].kind == Texture::Kind::bitmap && !scene.textures[t].nearest;
            ASSERT_TRUE(close || !smooth) << "texture " << t << " at " << points[i].x << " " << points[i].y;
        }
        EXPECT_LE(different, 1) << "texture " << t << ": points within rounding of an edge between texels";
    }
}

TEST(TextureKernel, SlopesAreThePathTracers) {
    Random random(22);
    Scene scene;
    for (const bool nearest : {false, true}) {
        scene.textures.push_back(random_bitmap(random, 7, 4));
        scene.textures.back().wrap_v = Texture::Wrap::mirror;
        scene.textures.back().nearest = nearest;  // a relief is interpolated all the same
        scene.textures.back().to_uv = glm::dmat3(2.0, 0.5, 0.0, -0.25, 1.5, 0.0, 0.3, -0.2, 1.0);
    }
    Texture squares;
    squares.kind = Texture::Kind::checkerboard;
    scene.textures.push_back(squares);
    std::vector<float4> points;
    for (int i = 0; i < 2000; ++i) points.emplace_back(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0), 0, 0);
    for (std::size_t t = 0; t < scene.textures.size(); ++t) {
        const std::vector<float4> found = values(scene, static_cast<int>(t), points, "texture_slopes");
        int different = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::vec2 expected = look_up_slope(scene.textures[t], glm::vec2(points[i]));
            different += glm::distance(glm::vec2(found[i]), expected) < 1e-3F * (1.0F + glm::length(expected)) ? 0 : 1;
        }
        EXPECT_LE(different, 4) << "texture " << t << ": points within rounding of an edge between texels";
    }
}

TEST(TextureKernel, NoneIsWhite) {
    Scene scene;
    scene.textures.emplace_back();
    scene.textures.back().kind = Texture::Kind::checkerboard;
    EXPECT_EQ(values(scene, -1, {float4(0.3F, 0.2F, 0, 0)})[0], float4(1.0F));
}

}  // namespace
