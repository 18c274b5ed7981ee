// Data URIs inside glTF texts are decoded without a copy of their text, and mean what they meant.
#include "scene/gltf/embedded_files.h"
#include "unit/gltf_fixture.h"

namespace pencil::test {
namespace {

std::string large_bytes(std::size_t count) {
    std::string bytes;
    for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(i * 7 + i / 256);
    return bytes;
}

TEST(EmbeddedFiles, LongOnesAreTakenOutAndDecoded) {
    for (const std::size_t size : {6000U, 6001U, 6002U}) {
        const std::string first = large_bytes(size), second = large_bytes(2 * size);
        const std::string text = "{\"a\\\"\":\"data:x;base64," + GltfBuilder::base64(first) +
                                 "\",\"b\":[\"data:;base64,AAAA\",\"data:y;base64," + GltfBuilder::base64(second) + "\"]}";
        const EmbeddedFiles files(text);
        EXPECT_EQ(files.json(), "{\"a\\\"\":\"embedded data 0\",\"b\":[\"data:;base64,AAAA\",\"embedded data 1\"]}");
        for (const auto& [name, expected] : {std::pair("embedded data 0", first), std::pair("embedded data 1", second)}) {
            ASSERT_TRUE(files.has(name));
            std::vector<unsigned char> bytes;
            ASSERT_TRUE(files.decode(name, bytes));
            EXPECT_EQ(std::string(bytes.begin(), bytes.end()), expected);
        }
        EXPECT_FALSE(files.has("embedded data 2"));
        EXPECT_FALSE(files.has("embedded data "));
        EXPECT_FALSE(files.has("other.bin"));
    }
}

TEST(EmbeddedFiles, WhatIsNotPlainStaysInTheText) {
    const std::string letters(6000, 'A');
    for (const std::string& text : {"\"data:x;base64,\\/" + letters + "\"", "\"data:x," + letters + "\"", "\"" + letters + "\"",
                                    "\"data:x;base64," + letters, std::string("\""), std::string("\"\\"), std::string()})
        EXPECT_EQ(EmbeddedFiles(text).json(), text);
    std::vector<unsigned char> bytes;
    EXPECT_FALSE(EmbeddedFiles("\"data:x;base64,%" + letters + "\"").decode("embedded data 0", bytes));
}

class EmbeddedGltf : public GltfTest {};

TEST_F(EmbeddedGltf, BuffersAndPicturesOfAnySize) {
    std::vector<unsigned char> noise(std::size_t{3} * 64 * 64);
    for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<unsigned char>(i * i * 2654435761U >> 13);
    GltfBuilder builder;
    builder.add("images", {{"uri", "data:image/png;base64," + GltfBuilder::base64(png(64, 64, 3, noise))}});
    builder.add("textures", {{"source", 0}});
    builder.material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    builder.view(large_bytes(10000));
    const Scene scene = load(builder);
    EXPECT_EQ(scene.triangles.size(), 1U);
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0].texels.size(), std::size_t{64} * 64);
    builder.json["images"][0]["uri"] = "data:image/png;base64,*" + std::string(6000, 'A');
    expect_message(builder, "not in base 64");
}

}  // namespace
}  // namespace pencil::test
