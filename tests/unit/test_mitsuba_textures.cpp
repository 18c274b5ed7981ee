// Mitsuba's textures, and the pictures behind them.
#include <OpenImageIO/imageio.h>

#include <glm/gtc/packing.hpp>

#include "scene/textures/add_texture.h"
#include "scene/textures/decode_image.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

/// Two texels: white, and code 188 (0.5029 linear).
const char* const two_texels = "P3 2 1 255\n255 255 255\n188 188 188\n";

class MitsubaTextures : public SceneTest {
protected:
    void SetUp() override {
        SceneTest::SetUp();
        write("t/a.ppm", two_texels);
        write("t/red.ppm", "P3 1 1 255\n255 0 0\n");
    }
    static std::string bitmap(const std::string& inside = "", const std::string& file = "t/a.ppm",
                              const std::string& name = "reflectance") {
        return "<texture type=\"bitmap\" name=\"" + name + "\"><string name=\"filename\" value=\"" + file + "\"/>" + inside + "</texture>";
    }
    Scene with_reflectance(const std::string& texture) const {
        return load_body("<shape type=\"rectangle\"><bsdf type=\"diffuse\">" + texture + "</bsdf></shape>");
    }
    static glm::vec4 texel(const Scene& scene, std::size_t texture, std::size_t i) {
        return glm::unpackHalf(scene.textures.at(texture).texels.at(i));
    }
    void write_exr(const std::string& name, const std::vector<float>& rgb, int width) const {
        const auto out = OIIO::ImageOutput::create("openexr");
        const OIIO::ImageSpec spec(width, static_cast<int>(rgb.size()) / 3 / width, 3, OIIO::TypeDesc::FLOAT);
        ASSERT_TRUE(out && out->open((folder_ / name).string(), spec));
        ASSERT_TRUE(out->write_image(OIIO::TypeDesc::FLOAT, rgb.data()));
    }
};

TEST_F(MitsubaTextures, BytesAreDecodedUnlessRaw) {
    const Scene scene = with_reflectance(bitmap());
    const SceneMaterial& m = scene.materials[0];
    EXPECT_EQ(m.albedo, glm::vec3(1.0F));
    ASSERT_EQ(m.albedo_texture, 0);
    EXPECT_EQ(scene.textures[0].width, 2);
    EXPECT_EQ(texel(scene, 0, 0), glm::vec4(1.0F));
    EXPECT_NEAR(texel(scene, 0, 1).x, 0.5029, 1e-3);
    for (const char* raw : {"<boolean name=\"raw\" value=\"true\"/>", "<float name=\"gamma\" value=\"1\"/>"})
        EXPECT_NEAR(texel(with_reflectance(bitmap(raw)), 0, 1).x, 188 / 255.0, 1e-3);
    EXPECT_NEAR(texel(with_reflectance(bitmap("<float name=\"gamma\" value=\"2\"/>")), 0, 1).x, std::pow(188 / 255.0, 2), 1e-3);
}

TEST_F(MitsubaTextures, FloatsAreLinear) {
    write_exr("t/a.exr", {0.25F, 2.0F, 1e9F, 0.5F, 0.5F, 0.5F}, 2);
    const Scene scene = with_reflectance(bitmap("", "t/a.exr"));
    EXPECT_NEAR(texel(scene, 0, 0).x, 0.25, 1e-4);
    EXPECT_EQ(texel(scene, 0, 0).y, 2.0F);
    EXPECT_EQ(texel(scene, 0, 0).z, 65504.0F);  // the largest half
}

TEST_F(MitsubaTextures, SamplingIsOfTheTexture) {
    Scene scene =
        with_reflectance(bitmap("<string name=\"filter_type\" value=\"nearest\"/><string name=\"wrap_mode\" value=\"mirror\"/>"
                                "<transform name=\"to_uv\"><scale x=\"2\" y=\"3\"/><translate x=\"0.5\"/></transform>"));
    EXPECT_TRUE(scene.textures[0].nearest);
    EXPECT_EQ(scene.textures[0].wrap_v, Texture::Wrap::mirror);
    EXPECT_EQ(scene.textures[0].to_uv * glm::dvec3(1, 1, 1), glm::dvec3(2.5, 3, 1));
    scene = with_reflectance(
        bitmap("<float name=\"uscale\" value=\"2\"/><float name=\"voffset\" value=\"0.5\"/><string name=\"wrapModeU\" value=\"clamp\"/>"));
    EXPECT_EQ(scene.textures[0].to_uv * glm::dvec3(1, 1, 1), glm::dvec3(2, 1.5, 1));
    EXPECT_EQ(scene.textures[0].wrap_u, Texture::Wrap::clamp);
    EXPECT_EQ(scene.textures[0].wrap_v, Texture::Wrap::repeat);
}

TEST_F(MitsubaTextures, CheckerboardsAndScales) {
    Scene scene = with_reflectance("<texture type=\"checkerboard\" name=\"reflectance\"><rgb name=\"color1\" value=\"1 0 0\"/></texture>");
    EXPECT_EQ(scene.textures[0].kind, Texture::Kind::checkerboard);
    EXPECT_EQ(scene.textures[0].colours[0], glm::vec3(0.4F));
    EXPECT_EQ(scene.textures[0].colours[1], glm::vec3(1, 0, 0));
    scene = with_reflectance("<texture type=\"scale\" name=\"reflectance\"><float name=\"scale\" value=\"0.5\"/>" +
                             bitmap("", "t/a.ppm", "") + "</texture>");
    EXPECT_EQ(scene.materials[0].albedo, glm::vec3(0.5F));
    EXPECT_EQ(scene.materials[0].albedo_texture, 0);
    expect_approximation("<shape type=\"cube\"><bsdf type=\"diffuse\"><texture name=\"reflectance\" type=\"gridtexture\"/></bsdf></shape>",
                         3, "read as one plain colour");
}

TEST_F(MitsubaTextures, ReferencesAreLoadedOnce) {
    const Scene scene = load_body(
        "<texture type=\"bitmap\" id=\"t\"><string name=\"filename\" value=\"t\\a.ppm\"/></texture>\n"
        "<shape type=\"cube\"><bsdf type=\"plastic\"><ref id=\"t\" name=\"diffuse_reflectance\"/></bsdf></shape>\n"
        "<shape type=\"cube\"><bsdf type=\"diffuse\">" +
        bitmap() +
        "</bsdf></shape>\n"
        "<shape type=\"cube\"><bsdf type=\"roughconductor\"><ref id=\"t\" name=\"alpha\"/></bsdf></shape>");
    EXPECT_EQ(scene.textures.size(), 2U);  // as a colour, and as a number
    EXPECT_EQ(scene.materials[0].albedo_texture, scene.materials[1].albedo_texture);
    EXPECT_EQ(scene.materials[2].alpha_texture, 1);
    EXPECT_EQ(scene.warnings, std::vector<std::string>());
}

TEST_F(MitsubaTextures, NumbersTakeTheLuminance) {
    const Scene scene = load_body("<shape type=\"cube\"><bsdf type=\"mask\">" + bitmap("", "t/red.ppm", "opacity") +
                                  "<bsdf type=\"diffuse\"/></bsdf></shape>");
    const SceneMaterial& m = scene.materials[scene.triangles[0].material];
    EXPECT_EQ(m.weight, 1.0F);
    EXPECT_NEAR(texel(scene, static_cast<std::size_t>(m.weight_texture), 0).x, 0.2127, 1e-3);
}

TEST_F(MitsubaTextures, NormalMapsShouldBeRaw) {
    const auto scene = [&](const std::string& raw) {
        return load_body("<shape type=\"cube\"><bsdf type=\"normalmap\">" + bitmap(raw, "t/a.ppm", "normalmap") +
                         "<bsdf type=\"diffuse\"/></bsdf></shape>");
    };
    EXPECT_TRUE(has_warning(scene(""), "\"raw\" should be true"));
    EXPECT_EQ(scene("<boolean name=\"raw\" value=\"true\"/>").warnings, std::vector<std::string>());
}

TEST_F(MitsubaTextures, LightsMayHaveThem) {
    const Scene scene =
        load_body("<shape type=\"rectangle\"><emitter type=\"area\">" + bitmap("", "t/a.ppm", "radiance") + "</emitter></shape>");
    EXPECT_EQ(scene.shapes[0].radiance, glm::vec3(1.0F));
    EXPECT_EQ(scene.shapes[0].radiance_texture, 0);
}

TEST_F(MitsubaTextures, ColoursOfVertices) {
    write("m.ply",
          "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float r\nproperty float "
          "g\n"
          "property float b\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0 1 0 0\n1 0 0 0 1 0\n0 1 0 0 0 1\n3 "
          "0 1 2\n");
    const Scene scene = load_body(
        "<shape type=\"cube\"/>\n<shape type=\"ply\"><string name=\"filename\" value=\"m.ply\"/><bsdf type=\"diffuse\">"
        "<texture name=\"reflectance\" type=\"mesh_attribute\"><string name=\"name\" value=\"vertex_color\"/></texture></bsdf></shape>");
    ASSERT_EQ(scene.colours.size(), scene.positions.size());
    EXPECT_EQ(scene.colours.front(), glm::vec3(1.0F));
    EXPECT_EQ(scene.colours.back(), glm::vec3(0, 0, 1));
    EXPECT_EQ(scene.textures[0].kind, Texture::Kind::vertex_colours);
}

TEST_F(MitsubaTextures, PicturesThatAreNotThere) {
    const auto texture = [](const std::string& name) {
        return "<texture type=\"bitmap\" name=\"" + name + "\"><string name=\"filename\" value=\"C:\\me\\no.png\"/></texture>\n";
    };
    const auto in_shape = [](const std::string& bsdf) { return "<shape type=\"cube\">" + bsdf + "</shape>"; };
    const std::string diffuse = "<bsdf type=\"diffuse\">\n" + texture("reflectance") + "</bsdf>";
    expect_approximation(in_shape(diffuse), 4, "is not there: the default of what it is for stands in for it");
    EXPECT_EQ(load_body(in_shape(diffuse)).materials.at(0).albedo, glm::vec3(0.5F));
    const Scene mask = load_body(in_shape("<bsdf type=\"mask\">" + texture("opacity") + diffuse + "</bsdf>"));
    EXPECT_EQ(mask.materials.at(mask.triangles.at(0).material).weight, 1.0F);
    const Scene bump = load_body(in_shape("<bsdf type=\"bumpmap\">" + texture("") + "<bsdf type=\"plastic\"/></bsdf>"));
    EXPECT_EQ(bump.materials.at(0).normal_texture, no_texture);
    expect_error("<shape type=\"cube\"><emitter type=\"area\">\n" + texture("radiance") + "</emitter></shape>", 4, "is refused");
}

TEST_F(MitsubaTextures, BadPicturesAreErrors) {
    const auto expect = [&](const std::string& content, const std::string& part) {
        write("t/bad", content);
        expect_error("<bsdf type=\"diffuse\">\n" + bitmap("", "t/bad") + "</bsdf>", 4, part);
    };
    expect("", "is not a picture in a known format");
    expect("GIF89a", "is not a picture in a known format");
    expect("P6 100000 100000 255\n", "is too large");
    // A TGA of runs, 10000 x 10000, and nothing behind its header.
    expect(std::string("\0\0\x0a\0\0\0\0\0\0\0\0\0\x10\x27\x10\x27\x18\0", 18) + std::string(64, '\x7f'),
           "do not hold 10000 x 10000 pixels");
    expect("P6 100 100 255\nabc", "");
    expect(std::string("\x89PNG\r\n\x1a\n", 8) + "nothing", "is damaged");
    expect(std::string("\xff\xd8\xff", 3), "is damaged");
    expect(std::string("\x76\x2f\x31\x01", 4), "is damaged");
    expect_error(
        "<texture id=\"a\" type=\"scale\"><ref id=\"a\"/></texture><bsdf type=\"diffuse\"><ref id=\"a\" name=\"reflectance\"/></bsdf>", 3,
        "");
}

TEST_F(MitsubaTextures, PicturesInMemory) {
    Scene scene;
    EXPECT_THROW(add_texture_bytes(scene, "nothing", "a", colour_use, "here"), SceneError);
    std::ifstream file(write("t/b.ppm", two_texels), std::ios::binary);
    EXPECT_EQ(add_texture_file(scene, folder_ / "t/b.ppm", {1.0, TextureUse::Channel::green}, "here"), 0);
    EXPECT_EQ(add_texture_file(scene, folder_ / "t/b.ppm", {1.0, TextureUse::Channel::green}, "here"), 0);
    EXPECT_EQ(add_texture_file(scene, folder_ / "t/b.ppm", raw_use, "here"), 1);
    TextureSampling clamped;
    clamped.wrap_u = Texture::Wrap::clamp;
    EXPECT_EQ(add_texture_file(scene, folder_ / "t/b.ppm", raw_use, "here", clamped), 2);
}

TEST_F(MitsubaTextures, PngInMemoryIsAsInAFile) {
    const auto out = OIIO::ImageOutput::create("png");
    const std::vector<unsigned char> rgba{255, 128, 0, 64};
    OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    ASSERT_TRUE(out && out->open((folder_ / "a.png").string(), spec));
    ASSERT_TRUE(out->write_image(OIIO::TypeDesc::UINT8, rgba.data()));
    out->close();
    std::ifstream stream(folder_ / "a.png", std::ios::binary);
    const std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const DecodedImage in_memory = decode_image_bytes(bytes, "a", "here"), in_file = decode_image_file(folder_ / "a.png", "here");
    EXPECT_EQ(in_memory.texels, in_file.texels);
    EXPECT_TRUE(in_memory.has_opacity && in_memory.is_encoded);
    EXPECT_NEAR(in_memory.texels[0].y, 128 / 255.0, 1e-6);  // not multiplied by the opacity
    for (std::size_t n = 0; n < bytes.size(); ++n) {        // cut anywhere: an error or a picture, no crash
        try {
            decode_image_bytes(std::string_view(bytes).substr(0, n), "a", "here");
        } catch (const SceneError&) {
        }
    }
}

}  // namespace
}  // namespace pencil::test
