// glTF files written and loaded by tests.
#pragma once

#include <OpenImageIO/imageio.h>

#include "unit/gltf_builder.h"
#include "unit/scene_fixture.h"

namespace pencil::test {

class GltfTest : public SceneTest {
protected:
    Scene load(const GltfBuilder& builder) const { return load_scene(write("scene.gltf", builder.gltf())); }

    /// The message of the SceneError, or "" if the file loads.
    std::string message_of(const std::string& bytes, const std::string& name = "scene.gltf") const {
        try {
            load_scene(write(name, bytes));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::scene) << error.what();
            return error.what();
        }
        return "";
    }
    void expect_message(const GltfBuilder& builder, const std::string& part) const {
        const std::string message = message_of(builder.gltf());
        EXPECT_NE(message.find("scene.gltf: "), std::string::npos) << message;
        EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
    }

    /// The bytes of a PNG file, `channels` values for each pixel.
    std::string png(int width, int height, int channels, const std::vector<unsigned char>& pixels) const {
        const std::string file = (folder_ / "made.png").string();
        const auto output = OIIO::ImageOutput::create(file);
        OIIO::ImageSpec spec(width, height, channels, OIIO::TypeDesc::UINT8);
        spec.attribute("oiio:UnassociatedAlpha", 1);
        EXPECT_TRUE(output->open(file, spec) && output->write_image(OIIO::TypeDesc::UINT8, pixels.data()) && output->close());
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    /// A texture of one image in the buffer; its index.
    int texture(GltfBuilder& builder, const std::string& bytes) const {
        const int image = builder.add("images", {{"bufferView", builder.view(bytes)}, {"mimeType", "image/png"}});
        return builder.add("textures", {{"source", image}});
    }
};

}  // namespace pencil::test
