// Scene files that must be refused, each with its file, line and reason; none may crash or hang the program.
#include <sys/stat.h>

#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

class BadScenes : public SceneTest {
protected:
    static std::string message_of(const std::filesystem::path& file) {
        try {
            load_scene(file);
        } catch (const SceneError& error) {
            return error.what();
        }
        return "";
    }
    void expect_text_error(const std::string& text, const std::string& part) const {
        const std::string message = error_of(text);
        EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
    }
};

void expect_part(const std::string& message, const std::string& part) {
    EXPECT_NE(message.find(part), std::string::npos) << "no \"" << part << "\" in: " << message;
}

TEST_F(BadScenes, FilesThatAreNoFiles) {
    expect_part(message_of(folder_ / "none.xml"), "does not exist");
    expect_part(message_of(folder_), "is a directory");
    expect_part(message_of("/dev/zero"), "is not a regular file");
    ASSERT_EQ(mkfifo((folder_ / "fifo.xml").c_str(), 0600), 0);
    expect_part(message_of(folder_ / "fifo.xml"), "is not a regular file");
    expect_part(message_of(write("a.obj", "v 0 0 0")), "a.obj: the file has no faces");
    expect_part(message_of(write("a.ply", "ply")), "a.ply:1: the header has no line");
}

TEST_F(BadScenes, TextThatIsNoScene) {
    expect_text_error("", "the file is empty");
    expect_text_error(" \n\t", "the file is empty");
    expect_text_error("x", "scene.xml:1: this is not well-formed XML");
    expect_text_error("hello\nworld", "not well-formed XML");
    expect_text_error(std::string("\x89PNG\r\n\x1a\n\0\0\0", 11), "the format is PNG: an image is no scene");
    expect_text_error(std::string("\xff\xfe<\0s\0", 6), "scene.xml:1: this is not well-formed XML");  // UTF-16
    expect_text_error("<scene version=\"3.0.0\">\xc0\x80</scene>", "unexpected text");
    expect_text_error(std::string("<scene\0", 7), "binary data, not XML");
    expect_text_error("<mitsuba version=\"3.0.0\"/>", "scene.xml:1: the root element is <mitsuba>, not <scene>");
    expect_text_error("<scene version=\"3.0.0\"/>", "the scene has no sensor");
    expect_text_error("<scene version=\"3.0.0\"/><scene/>", "one root");
    expect_text_error("<scene version=\"x\"/>", "is not a version number");
    expect_text_error("<scene version=\"3.0.0\">\n\n<sensor type=\"perspective\">\n</scene>", "scene.xml:4: this is not well-formed XML");
}

/// They are passed over, and what they name is not opened.
TEST_F(BadScenes, DoctypesDeclareNothing) {
    const std::string refused = "a DOCTYPE may only name the kind of document";
    expect_text_error("<!DOCTYPE scene [<!ENTITY a \"b\">]>\n<scene version=\"3.0.0\"/>", refused);
    expect_text_error("<!DOCTYPE scene SYSTEM \"file:///etc/passwd\">\n<scene version=\"3.0.0\">&a;</scene>", "unexpected text \"&a;\"");
    expect_text_error("<scene version=\"3.0.0\"><!DOCTYPE a></scene>", refused);
    for (const char* doctype : {"<!DOCTYPE scene>", "<!DOCTYPE scene SYSTEM \"mitsuba.dtd\">", "<!DOCTYPE scene PUBLIC \"a\" \"b\">"})
        EXPECT_EQ(error_of("<?xml version=\"1.0\"?>\n" + std::string(doctype) + in_scene("")), "") << doctype;
}

TEST_F(BadScenes, SizesAreLimited) {
    std::string deep = "<scene version=\"3.0.0\">";
    for (int i = 0; i < 100000; ++i) deep += "<bsdf type=\"twosided\">";
    for (int i = 0; i < 100000; ++i) deep += "</bsdf>";
    expect_text_error(deep + "</scene>", "nested more than 64 deep");
    std::string many = "<scene version=\"3.0.0\">";
    for (int i = 0; i < 1100000; ++i) many += "<bsdf/>";
    expect_text_error(many + "</scene>", "more than 1000000 elements");
    expect_error("<bsdf type=\"" + std::string(70000, 'x') + "\"/>", 3, "longer than 65536 bytes");
    std::string attributes = "<bsdf";
    for (int i = 0; i < 1000; ++i) attributes += " a" + std::to_string(i) + "=\"\"";
    expect_error(attributes + "/>", 3, "more than 16 attributes");
    std::string doubling = "<default name=\"v0\" value=\"xx\"/>";
    for (int i = 1; i < 40; ++i) {
        const std::string before = "$v" + std::to_string(i - 1) + " ";
        doubling += "<default name=\"v" + std::to_string(i) + "\" value=\"" + before + before + "\"/>";
    }
    expect_error(doubling, 3, "grows beyond");
    expect_text_error("<scene>" + std::string(std::size_t{17} << 20, ' ') + "</scene>", "the limit is");
}

TEST_F(BadScenes, UnknownElements) {
    expect_error("\n<shap type=\"cube\"/>", 4, "element <shap> is not known; did you mean <shape>?");
    expect_error("<include filename=\"other.xml\"/>", 3, "does not exist");
    expect_error("<include/>", 3, "<include> needs a filename");
    expect_error("<include filename=\"scene.xml\"/>", 3, "includes itself");
    expect_error("<emitter type=\"area\"/>", 3, "must stand inside the shape");
    expect_error("<shape type=\"cube\">\n<bsdf type=\"diffuse\"/><bsdf type=\"diffuse\"/></shape>", 4, "more than one bsdf");
    expect_error("<shape type=\"cube\">\n<default name=\"a\" value=\"1\"/>text</shape>", 3, "unexpected text \"text\"");
    expect_error("<rgb name=\"x\" value=\"1\"/>", 3, "cannot stand directly inside <scene>");
    expect_error("<shape type=\"cube\"><float name=\"x\" value=\"1\">\n<float name=\"x\" value=\"1\"/></float></shape>", 4,
                 "cannot contain elements");
    expect_error("<shape type=\"cube\"><translate x=\"1\"/></shape>", 3, "<translate> cannot stand inside shape type \"cube\"");
    expect_error("<bsdf type=\"twosided\"/>", 3, "exactly one nested bsdf");
    expect_error("<bsdf type=\"mask\"/>", 3, "exactly one nested bsdf");
    expect_error("<bsdf type=\"blendbsdf\"><bsdf type=\"diffuse\"/></bsdf>", 3, "exactly two nested bsdfs");
    expect_error("<texture type=\"bitmap\" id=\"t\"/><bsdf type=\"diffuse\">\n<ref name=\"reflectance\" id=\"t\"/></bsdf>", 3,
                 "needs a filename");
    EXPECT_NE(
        error_of("<scene version=\"3.0.0\">\n<sensor type=\"irradiancemeter\"/></scene>").find("takes no picture; supported: perspective"),
        std::string::npos);
}

TEST_F(BadScenes, AllDefectsAreToldAtOnce) {
    const std::string message = error_of_body(
        "<shap/>\n<shape type=\"obj\"/>\n<bsdf type=\"dielectric\"><string name=\"int_ior\" value=\"watr\"/></bsdf>\n"
        "<shape type=\"sphere\"><float name=\"radius\" value=\"x\"/><bsdf type=\"plastic\"><float name=\"int_ior\" "
        "value=\"-1\"/></bsdf></shape>");
    for (const char* part :
         {"scene.xml:3: element <shap>", "scene.xml:4: shape type \"obj\" needs a filename",
          "scene.xml:5: bsdf type \"dielectric\": int_ior \"watr\" is neither a number nor a known name; did you mean \"water\"?",
          "scene.xml:6: shape type \"sphere\""})
        expect_part(message, part);
    std::string many;
    for (int i = 0; i < 1000; ++i) many += "<shap/>\n";
    expect_part(error_of_body(many), "and 950 more errors");
}

TEST_F(BadScenes, WhatCanBeApproximatedIsAWarning) {
    expect_approximation("<emitter type=\"projector\"/>", 3, "emitter type \"projector\" is not supported: left out");
    expect_approximation("<integrator type=\"depth\"/>", 3, "integrator type \"depth\" is not supported: read as \"path\"");
    expect_approximation("<sensor type=\"irradiancemeter\"/>", 3, "takes no picture: left out");
    expect_approximation("<sensor type=\"perspective\"><film type=\"newfilm\"/></sensor>", 3, "film type \"newfilm\" is not known");
    expect_approximation("<sensor type=\"perspective\"><film type=\"hdrfilm\">\n<rfilter type=\"sinc\"/></film></sensor>", 4,
                         "rfilter type \"sinc\" is not supported: read as gaussian");
    expect_approximation("<shape type=\"hair\"/>", 3, "shape type \"hair\" is not supported: left out");
    expect_approximation("<shape type=\"cube\">\n<medium name=\"interior\" type=\"homogeneous\"/></shape>", 3, "has a medium");
    expect_approximation("<shape type=\"cube\">\n<emitter type=\"point\"/></shape>", 4, "read as area");
    expect_approximation("<bsdf type=\"irawan\"/>", 3, "bsdf type \"irawan\" is not supported: read as diffuse");
    expect_approximation("<bsdf type=\"coating\"><bsdf type=\"diffuse\"/></bsdf>", 3, "the material inside is used alone");
    expect_approximation("<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.5, 1.1, 0.5\"/></bsdf>", 3, "must lie in [0, 1]");
    expect_approximation("<bsdf type=\"diffuse\"><spectrum name=\"reflectance\" value=\"400:0.5, 700:1.5\"/></bsdf>", 3,
                         "must not exceed 1");
    expect_approximation("<integrator type=\"$integrator\"/>", 3, "\"$integrator\" is not defined; give it by -D integrator=VALUE");
    expect_approximation("<shape type=\"sphere\"><float name=\"radius\" value=\"$missing\"/></shape>", 3, "\"$missing\" is not defined");
    expect_approximation("<shape type=\"cube\"><subsurface type=\"dipole\"/></shape>", 3, "<subsurface> is not supported: left out");
}

TEST_F(BadScenes, WarningsOfOneKindAreFew) {
    std::string many;
    for (int i = 0; i < 100; ++i) many += "<emitter type=\"new" + std::to_string(i) + "\"/>\n";
    const Scene scene = load_body(many);
    EXPECT_EQ(scene.warnings.size(), 4U);
    EXPECT_TRUE(has_warning(scene, "and 96 more warnings like this one"));
}

TEST_F(BadScenes, ReferencesAndNames) {
    expect_error("<shape type=\"cube\">\n<ref id=\"whit\"/></shape><bsdf type=\"diffuse\" id=\"white\"/>", 4,
                 "nothing has the id \"whit\"; did you mean \"white\"?");
    expect_error("<bsdf type=\"diffuse\" id=\"a\"/>\n<bsdf type=\"diffuse\" id=\"a\"/>", 4,
                 "id \"a\" is used twice; it was given first at ");
    expect_error("<bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>", 3, "refers to itself");
    expect_error("<alias id=\"no\" as=\"b\"/>", 3, "nothing has the id \"no\"");
    expect_error("<shape type=\"cube\" id=\"a\" id=\"b\"/>", 3, "given twice");
    expect_error("<shape type=\"obj\"><string name=\"filename\" value=\"$missing\"/></shape>", 3, "\"$missing\" is not defined");
    expect_error("<default value=\"1\"/>", 3, "needs a name");
    expect_error("<shape type=\"sphere\"><float name=\"radius\" value=\"1\"/>\n<float name=\"radius\" value=\"1\"/></shape>", 4,
                 "given twice");
    const std::string message = error_of_body(
        "<bsdf type=\"twosided\" id=\"a\"/><bsdf type=\"x\" id=\"\x1b[31m&#10;%n%s\xc2\x9b\"/>"
        "<bsdf type=\"x\" id=\"\x1b[31m&#10;%n%s\xc2\x9b\"/>");
    expect_part(message, "\\x1b[31m");
    EXPECT_EQ(message.find('\x1b'), std::string::npos);
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_EQ(message.find("\xc2\x9b"), std::string::npos);
    EXPECT_LT(error_of_body("<ref id=\"" + std::string(60000, 'x') + "\"/>").size(), 500U);
}

TEST_F(BadScenes, Numbers) {
    const auto radius = [](const std::string& value) {
        return "<shape type=\"sphere\">\n<float name=\"radius\" value=\"" + value + "\"/></shape>";
    };
    expect_error(radius("nan"), 4, "parameter \"radius\": \"nan\" is not a finite number");
    expect_error(radius("inf"), 4, "\"inf\" is not a finite number");
    expect_error(radius("1e400"), 4, "range of double precision");
    expect_error(radius("0x10"), 4, "\"0x10\" is not a number");
    expect_error(radius("1,5"), 4, "\"1,5\" is not a number (the decimal mark is a point)");
    expect_error(radius("--3"), 4, "\"--3\" is not a number");
    expect_error(radius("+-3"), 4, "is not a number");
    expect_error(radius(""), 4, "a number is missing");
    expect_error(radius("1 2"), 4, "is not a number");
    expect_error(radius(std::string(10000, '9')), 4, "range of double precision");
    expect_error(radius("0"), 4, "radius must be positive");
    expect_error(radius("-1"), 4, "radius must be positive");
    expect_error("<shape type=\"sphere\"><string name=\"radius\" value=\"1\"/></shape>", 3, "must be a <float>, not a <string>");
    expect_error("<shape type=\"sphere\"><float name=\"radius\"/></shape>", 3, "needs a value");
    expect_error("<shape type=\"sphere\"><float value=\"1\"/></shape>", 3, "needs a name");
    expect_error("<shape type=\"cube\"><boolean name=\"flip_normals\" value=\"yes\"/></shape>", 3, "neither true nor false");
    expect_error("<shape type=\"sphere\"><point name=\"center\" x=\"nan\"/></shape>", 3, "not a finite number");
    expect_error("<shape type=\"cube\"><transform name=\"to_world\"><translate x=\"1e30\"/></transform></shape>", 3, "1e18");
    expect_error("<integrator type=\"path\"><integer name=\"max_depth\" value=\"0\"/></integrator>", 3, "max_depth must be -1");
    expect_error("<integrator type=\"path\"><integer name=\"max_depth\" value=\"-2\"/></integrator>", 3, "max_depth must be -1");
    expect_error("<integrator type=\"path\"><integer name=\"max_depth\" value=\"2.5\"/></integrator>", 3, "is not an integer");
    expect_error("<integrator type=\"path\"><integer name=\"max_depth\" value=\"99999999999\"/></integrator>", 3, "max_depth must be");
}

TEST_F(BadScenes, Sensors) {
    const auto sensor = [](const std::string& inside) { return "<sensor type=\"perspective\">\n" + inside + "</sensor>"; };
    for (const char* fov : {"0", "180", "-1", "500"})
        expect_error(sensor("<float name=\"fov\" value=\"" + std::string(fov) + "\"/>"), 4, "fov must lie between 0 and 180");
    expect_error(sensor("<float name=\"fov\" value=\"4\"/><string name=\"fov_axis\" value=\"up\"/>"), 4, "fov_axis \"up\"");
    expect_error(sensor("<string name=\"focal_length\" value=\"-5mm\"/>"), 4, "focal_length \"-5mm\"");
    expect_error(sensor("<string name=\"focal_length\" value=\"5mm\"/><float name=\"fov\" value=\"4\"/>"), 4, "not both");
    expect_error(sensor("<float name=\"near_clip\" value=\"0\"/>"), 4, "near_clip must be positive");
    expect_error(sensor("<float name=\"near_clip\" value=\"5\"/><float name=\"far_clip\" value=\"5\"/>"), 4, "far_clip must be greater");
    const auto film = [&](const std::string& name, const std::string& value) {
        return sensor("<film type=\"hdrfilm\"><integer name=\"" + name + "\" value=\"" + value + "\"/></film>");
    };
    expect_error(film("width", "0"), 4, "width must be from 1 to 1000000 pixels");
    expect_error(film("height", "-1"), 4, "height must be from 1 to 1000000 pixels");
    expect_error(film("width", "1000001"), 4, "width must be from 1 to");
    expect_error(film("width", "99999999999"), 4, "width must be from 1 to");
    expect_error(film("width", "x"), 4, "is not an integer");
    EXPECT_NE(load_text("<scene version=\"3.0.0\">" + film("width", "1000000") + "</scene>").sensor.width, 0);
    expect_error(sensor("<transform name=\"to_world\"><scale x=\"2\"/></transform>"), 4, "may only rotate, mirror and move");
    expect_error(sensor("<transform name=\"to_world\"><scale x=\"0\"/></transform>"), 4, "singular");
}

TEST_F(BadScenes, Colours) {
    const auto bsdf = [](const std::string& colour) { return "<bsdf type=\"diffuse\">\n" + colour + "</bsdf>"; };
    expect_error(bsdf("<rgb name=\"reflectance\" value=\"-0.1\"/>"), 4, "must not be negative");
    expect_error(bsdf("<rgb name=\"reflectance\" value=\"nan\"/>"), 4, "finite");
    expect_error(bsdf("<rgb name=\"reflectance\" value=\"0.1, 0.2\"/>"), 4, "has 2 numbers, not one or three");
    expect_error(bsdf("<rgb name=\"reflectance\" value=\"#12345g\"/>"), 4, "is not a colour of the form \"#rrggbb\"");
    expect_error(bsdf("<rgb name=\"reflectance\" value=\"#fa0\"/>"), 4, "\"#fa0\" is too short for a colour; write \"#ffaa00\"");
    expect_error(bsdf("<srgb name=\"reflectance\" value=\"#ffaa0080\"/>"), 4, "write \"#ffaa00\", since a colour has no opacity");
    expect_error(bsdf("<rgb name=\"reflectance\" value=\"0.1 0.2 0.3 1\"/>"), 4,
                 "has 4 numbers, not one or three; a colour has no opacity");
    expect_error(bsdf("<rgb name=\"reflectance\"/>"), 4, "needs a value");
    expect_error(bsdf("<string name=\"reflectance\" value=\"red\"/>"), 4, "is not a colour");
    expect_error(bsdf("<spectrum name=\"reflectance\" filename=\"a.spd\"/>"), 4, "does not exist");
    expect_error(bsdf("<spectrum name=\"reflectance\" value=\"400:0.5\"/>"), 4, "at least two");
    expect_error(bsdf("<spectrum name=\"reflectance\" value=\"500:0.5, 400:0.5\"/>"), 4, "must increase");
    expect_error(bsdf("<spectrum name=\"reflectance\" value=\"400:0.5, 500:-1\"/>"), 4, "must not be negative");
    expect_error(bsdf("<spectrum name=\"reflectance\" value=\"400:0.5, 500\"/>"), 4, "mixes");
    expect_error(bsdf("<spectrum name=\"reflectance\" value=\"400:0.5, :1\"/>"), 4, "a number is missing");
    expect_error("<shape type=\"cube\"><emitter type=\"area\">\n<rgb name=\"radiance\" value=\"-1\"/></emitter></shape>", 4,
                 "must not be negative");
    expect_error("<shape type=\"cube\"><emitter type=\"area\">\n<rgb name=\"radiance\" value=\"1e39\"/></emitter></shape>", 4,
                 "single precision");
    EXPECT_EQ(error_of_body("<shape type=\"cube\"><emitter type=\"area\"><rgb name=\"radiance\" value=\"1e30\"/></emitter></shape>"), "");
    expect_error("<emitter type=\"point\">\n<point name=\"position\" value=\"0\"/><transform name=\"to_world\"/></emitter>", 4, "not both");
}

/// A scene named without a folder, as from its own folder on the command line.
TEST_F(BadScenes, MissingMeshBesideAFileInTheWorkingFolder) {
    write("scene.xml", in_scene("<shape type=\"obj\"><string name=\"filename\" value=\"none.obj\"/></shape>"));
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    const std::string message = message_of("scene.xml");
    std::filesystem::current_path(before);
    expect_part(message, "scene.xml:3: \"none.obj\" does not exist");
}

TEST_F(BadScenes, MeshFiles) {
    const auto obj = [](const std::string& file) {
        return "\n<shape type=\"obj\">\n<string name=\"filename\" value=\"" + file + "\"/></shape>";
    };
    expect_error(obj("none.obj"), 4, "does not exist");
    expect_error(obj(""), 4, "the file name is empty");
    expect_error(obj("/etc/passwd"), 4, "leads outside the scene's folder; to allow it, give --allow \"/etc\"");
    expect_error(obj("../secret.obj"), 4, "leads outside the scene's folder");
    expect_error(obj("a/../../secret.obj"), 4, "leads outside");
    expect_error(obj("C:\\meshes\\a.obj"), 4, "is refused");
    expect_error(obj("file:///etc/passwd"), 4, "is refused");
    expect_error(obj("..\\secret.obj"), 4, "leads outside");
    expect_error("\n<shape type=\"obj\"/>", 4, "needs a filename");
    write("folder/x", "");
    expect_error(obj("folder"), 4, "is a directory");
    ASSERT_EQ(mkfifo((folder_ / "fifo.obj").c_str(), 0600), 0);
    expect_error(obj("fifo.obj"), 4, "is not a regular file");
    std::filesystem::create_symlink("/dev/zero", folder_ / "zero.obj");
    expect_error(obj("zero.obj"), 4, "leads outside the scene's folder");
    std::filesystem::create_directory_symlink("/", folder_ / "root");
    expect_error(obj("root/etc/passwd"), 4, "leads outside the scene's folder");
    write("bad.obj", "v 0 0 0\nf 1 2 3\n");
    expect_part(error_of_body(obj("bad.obj")), "bad.obj:2: face corner \"2\" names vertex 2, but there are 1 so far");
    write("bad.ply", "plz\n");
    expect_part(error_of_body("<shape type=\"ply\"><string name=\"filename\" value=\"bad.ply\"/></shape>"),
                "bad.ply:1: the first line is not \"ply\"");
    write("far.obj", "v 1e300 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
    expect_error(obj("far.obj"), 4, "further than 1e18");
    write("empty.obj", "");
    EXPECT_TRUE(has_warning(load_body(obj("empty.obj")), "has no triangles"));
}

const char* const whole_scene = R"(<?xml version="1.0"?>
<scene version="3.0.0">
    <default name="d" value="5"/>
    <integrator type="path"><integer name="max_depth" value="$d"/></integrator>
    <sensor type="perspective"><float name="fov" value="19.5"/>
        <transform name="to_world"><lookat origin="0,0,-5" target="0,0,0" up="0,1,0"/></transform>
        <film type="hdrfilm"><integer name="width" value="8"/><rfilter type="tent"/></film>
    </sensor>
    <bsdf type="twosided" id="w"><bsdf type="diffuse"><spectrum name="reflectance" value="400:0.1, 700:0.9"/></bsdf></bsdf>
    <shape type="sphere"><ref id="w"/><emitter type="area"><rgb name="radiance" value="#102030"/></emitter></shape>
</scene>
)";

TEST_F(BadScenes, TruncationAtEveryByteIsAnError) {
    const std::string text = whole_scene;
    ASSERT_EQ(error_of(text), "");
    const std::size_t end = text.rfind("</scene>") + 8;
    for (std::size_t n = 0; n < end; ++n) EXPECT_NE(error_of(text.substr(0, n)), "") << "cut after " << n << " bytes";
}

TEST_F(BadScenes, DamagedBytesNeverCrash) {
    const std::string text = whole_scene;
    for (std::size_t n = 0; n < text.size(); ++n) {
        for (const char byte : {'"', '<', '$', '9'}) {
            std::string damaged = text;
            damaged[n] = byte;
            error_of(damaged);  // checks that whatever is thrown is a SceneError
        }
    }
}

}  // namespace
}  // namespace pencil::test
