// Which format a file is in, by what it begins with; what is said of formats that have no reader.
#include <cstring>

#include "scene/formats/scene_format.h"
#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

using namespace std::string_literals;

class SceneFormats : public SceneTest {
protected:
    std::string message_of(const std::string& name, const std::string& content) const {
        try {
            load_scene(write(name, content));
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    }
    /// Whatever the file's name says.
    void expect_format(const std::string& content, const std::string& format, const std::string& advice) const {
        for (const char* name : {"a", "a.xml", "a.obj", "a.bin"}) {
            const std::string message = message_of(name, content);
            EXPECT_NE(message.find(name + ": the format is "s + format + ": "), std::string::npos) << format << ": " << message;
            EXPECT_NE(message.find(advice), std::string::npos) << message;
        }
    }
};

/// Two triangles with unit normals after 80 bytes.
std::string binary_stl() {
    const float triangle[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    std::string bytes = "made by hand";
    bytes.resize(80, ' ');
    bytes += "\x02\0\0\0"s;
    for (int i = 0; i < 2; ++i) {
        bytes.append(reinterpret_cast<const char*>(triangle), sizeof triangle);
        bytes += "\0\0"s;
    }
    return bytes;
}

/// Recognised whatever the file's name says: its reader answers.
TEST_F(SceneFormats, OtherFormatsThatAreRead) {
    for (const char* name : {"a", "a.xml", "a.obj", "a.bin"}) {
        EXPECT_EQ(message_of(name, "ply\nformat ascii 1.0\n").find("the format is"), std::string::npos);
        EXPECT_NE(message_of(name, "ply\nformat ascii 1.0\n").find("the header has no line"), std::string::npos);
        EXPECT_NE(message_of(name, "# made by hand\r\n\r\nmtllib a.mtl\r\nv 0 0 0\r\n").find("no faces"), std::string::npos);
        EXPECT_NE(message_of(name, "o cube\nv 0 0 0\n").find("no faces"), std::string::npos);
        EXPECT_NE(message_of(name, "{\n  \"asset\" : { \"version\" : \"2.0\" } }").find("no triangles"), std::string::npos);
        EXPECT_NE(message_of(name, "{\"accessors\":[{\"bufferView\":0}]}").find("not well-formed glTF"), std::string::npos);
        EXPECT_NE(message_of(name, "glTF\x02\0\0\0"s).find("ends within its header"), std::string::npos);
    }
    expect_format("solid cube\n facet normal 0 0 1\n", "STL", "convert it to PLY");
    expect_format(binary_stl(), "STL", "convert it to PLY");
}

TEST_F(SceneFormats, ScenesOfOtherProgramsAreNamed) {
    const std::string by_blender = "open it in Blender";
    expect_format("#usda 1.0\n(\n)\n", "USD", by_blender);
    expect_format("PXR-USDC\0\x08\0\0"s, "USD", by_blender);
    expect_format("PK\x03\x04\x0a\0\0\0\0\0scene.usdc"s, "USD", by_blender);
    expect_format("Kaydara FBX Binary  \0\x1a\0"s, "FBX", by_blender);
    expect_format("; FBX 7.4.0 project file\n", "FBX", by_blender);
    expect_format("<?xml version=\"1.0\"?>\n<!-- by hand -->\n<COLLADA xmlns=\"\">", "COLLADA", by_blender);
    expect_format("Ogawa\xff\0\x01"s, "Alembic", by_blender);
    expect_format("\x89HDF\r\n\x1a\n"s, "Alembic", by_blender);
    expect_format("BLENDER-v300", "Blender", by_blender);
    expect_format("# a scene\nLookAt 0 0 5  0 0 0  0 1 0\nCamera \"perspective\"\n", "pbrt", "published as Mitsuba XML");
    expect_format("Integrator \"path\"\n", "pbrt", "published as Mitsuba XML");
    expect_format("WorldBegin # now\n", "pbrt", "published as Mitsuba XML");
}

TEST_F(SceneFormats, ImagesAreNamed) {
    expect_format("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"s, "PNG", "an image is no scene");
    expect_format("\x76\x2f\x31\x01\x02\0\0\0"s, "OpenEXR", "an image is no scene");
    expect_format("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n", "Radiance HDR", "an image is no scene");
}

TEST_F(SceneFormats, AnythingElseIsNotAScene) {
    for (const std::string& content : {"hello world\n"s, "\0\0\0\0"s, "{\"a\": 1}"s, "Shape of things\n"s, "v"s, "plyers\n"s,
                                       "PK\x03\x04 a.txt"s, std::string(300, '\0'), std::string(5000, ' ')}) {
        EXPECT_NE(message_of("a.txt", content).find("a.txt: this is not a scene in a known format; known: PLY, OBJ, glTF, Mitsuba XML"),
                  std::string::npos)
            << message_of("a.txt", content);
    }
    EXPECT_NE(message_of("a.txt", "").find("the file is empty"), std::string::npos);
    // What nothing recognises but has the name of a scene: its reader says what is wrong.
    EXPECT_NE(message_of("a.xml", "hello world").find("a.xml:1: this is not well-formed XML"), std::string::npos);
}

TEST_F(SceneFormats, MitsubaWhateverTheName) {
    for (const char* name : {"scene", "scene.txt", "scene.obj", "scene.gltf"}) EXPECT_EQ(message_of(name, in_scene("")), "") << name;
    EXPECT_EQ(message_of("scene", "<!--" + std::string(2 * head_bytes, ' ') + "-->" + in_scene("")), "");
    EXPECT_NE(message_of("a.dae", "<mitsuba/>").find("the root element is <mitsuba>, not <scene>"), std::string::npos);
}

TEST_F(SceneFormats, AnyBytesHaveAnAnswer) {
    std::string bytes = binary_stl();
    for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_NE(message_of("a.bin", bytes.substr(0, n)), "") << n;
    for (const SceneFormat& format : scene_formats())
        for (std::size_t n = 0; n < 5; ++n) format.recognises(std::string_view("<!--").substr(0, n));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::memcpy(&bytes[84], &nan, sizeof nan);
    EXPECT_NE(message_of("a.bin", bytes).find("not a scene in a known format"), std::string::npos);
}

TEST_F(SceneFormats, ARowHasAReaderOrAdvice) {
    for (const SceneFormat& format : scene_formats()) {
        EXPECT_FALSE(format.name.empty());
        EXPECT_NE(format.recognises, nullptr) << format.name;
        EXPECT_NE(format.read == nullptr, format.advice.empty()) << format.name;
    }
}

}  // namespace
}  // namespace pencil::test
