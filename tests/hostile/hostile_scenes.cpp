// Rows 1 to 11, 33, 35 and 38: files that are none, XML that is none, XML without end, values out of range, names.
#include <sys/stat.h>

#include <filesystem>

#include "hostile/hostile_case.h"

namespace pencil_test {
namespace {

/// One path that names no regular file.
HostileCase path(const std::string& name, const std::string& says, const std::function<std::string(const Folder&)>& make) {
    return {name, 3, says, [=](const Folder& folder) { return Arguments{"render", make(folder), "-o", (folder / "a.exr").string()}; }};
}

/// A file of this many zeros that takes no room on the disk.
std::string sparse(const Folder& folder, const std::string& name, std::uintmax_t bytes, const std::string& begin = "") {
    const std::string file = folder.write(name, begin);
    std::filesystem::resize_file(file, bytes);
    return file;
}

std::vector<HostileCase> files() {
    const std::uintmax_t four_gib = std::uintmax_t{4} << 30;
    return {
        path("01-missing", "does not exist", [](const Folder& folder) { return (folder / "none.xml").string(); }),
        path("01-folder", "is a directory", [](const Folder& folder) { return folder.path().string(); }),
        path("01-device", "is not a regular file", [](const Folder&) { return "/dev/zero"; }),
        path("01-fifo", "is not a regular file",
             [](const Folder& folder) {
                 const std::string fifo = (folder / "pipe.xml").string();
                 return ::mkfifo(fifo.c_str(), 0600) == 0 ? fifo : "";
             }),
        path("01-empty", "is empty", [](const Folder& folder) { return folder.write("a.xml", ""); }),
        path("01-one-byte", "not well-formed XML", [](const Folder& folder) { return folder.write("a.xml", "<"); }),
        path("01-picture", "is no scene",
             [](const Folder& folder) { return folder.write("a.xml", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11)); }),
        path("35-xml-of-4-gib", "the limit is", [=](const Folder& folder) { return sparse(folder, "a.xml", four_gib, "<scene>"); }),
        path("35-obj-of-4-gib", "", [=](const Folder& folder) { return sparse(folder, "a.obj", four_gib, "v 0 0 0\n"); }),
        path("35-ply-of-4-gib", "", [=](const Folder& folder) { return sparse(folder, "a.ply", four_gib, "ply\n"); }),
        path("35-glb-of-4-gib", "", [=](const Folder& folder) { return sparse(folder, "a.glb", four_gib, "glTF"); }),
    };
}

std::vector<HostileCase> texts() {
    const std::string small = scene_around("");
    const auto xml = [](const std::string& name, int code, const std::string& says, const std::function<std::string()>& text) {
        return reads(name, code, says, "scene.xml", text);
    };
    const auto crlf = [=] {
        std::string text = small;
        for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.replace(at, 1, "\r\n");
        return text;
    };
    const auto utf16 = [=] {
        std::string text = "\xff\xfe";
        for (const char c : small) text += {c, '\0'};
        return text;
    };
    return {
        xml("02-byte-order-mark", 0, "", [=] { return "\xef\xbb\xbf" + small; }),
        xml("02-crlf", 0, "", crlf),
        xml("02-utf-16", 0, "", utf16),
        xml("03-billion-laughs", 3, "DOCTYPE",
            [] {
                std::string text = "<!DOCTYPE scene [<!ENTITY a0 \"ha\">";
                for (int i = 1; i < 30; ++i) {
                    const std::string before = "&a" + std::to_string(i - 1) + ";";
                    text += "<!ENTITY a" + std::to_string(i) + " \"" + repeated(before, 10) + "\">";
                }
                return text + "]><scene version=\"3.0.0\">&a29;</scene>";
            }),
        xml("03-file-as-entity", 3, "",
            [] { return "<!DOCTYPE scene [<!ENTITY a SYSTEM \"file:///etc/passwd\">]><scene version=\"3.0.0\">&a;</scene>"; }),
        xml("04-a-million-deep", 3, "", [] { return repeated("<bsdf>", 1000000) + repeated("</bsdf>", 1000000); }),
        xml("04-attribute-of-12-mib", 3, "longer than", [] { return scene_around("<bsdf type=\"" + std::string(12 << 20, 'x') + "\"/>"); }),
        xml("04-attribute-of-64-mib", 3, "the limit is",
            [] { return scene_around("<bsdf type=\"" + std::string(64 << 20, 'x') + "\"/>"); }),
        xml("04-a-million-attributes", 3, "attributes",
            [] {
                std::string text = "<bsdf";
                for (int i = 0; i < 1000000; ++i) text += " a" + std::to_string(i) + "=\"\"";
                return scene_around(text + "/>");
            }),
        xml("04-a-million-elements", 3, "elements", [] { return "<scene version=\"3.0.0\">" + repeated("<bsdf/>", 1100000) + "</scene>"; }),
        xml("05-cut", 3, "not well-formed XML", [=] { return small.substr(0, small.size() / 2); }),
        xml("06-unknown-element", 3, "did you mean <shape>?", [] { return scene_around("<shap type=\"cube\"/>"); }),
        scene_with("06-unknown-type", 0, "is not supported: left out", "<emitter type=\"projector\"/>"),
        scene_with("06-unknown-parameter", 0, "radius", "<shape type=\"sphere\"><float name=\"radiu\" value=\"1\"/></shape>"),
        scene_with("06-same-id-twice", 3, "is used twice", "<bsdf type=\"diffuse\" id=\"a\"/>\n<bsdf type=\"diffuse\" id=\"a\"/>"),
        scene_with("06-reference-to-nothing", 3, "nothing has the id", "<shape type=\"cube\"><ref id=\"a\"/></shape>"),
        scene_with("06-reference-to-itself", 3, "refers to itself", "<bsdf type=\"twosided\" id=\"a\"><ref id=\"a\"/></bsdf>"),
        scene_with("07-include-circle", 3, "includes itself", "<include filename=\"a.xml\"/>",
                   {{"a.xml", "<scene version=\"3.0.0\"><include filename=\"scene.xml\"/></scene>"}}),
        scene_with("07-include-outside", 3, "outside", "<include filename=\"../../etc/passwd\"/>"),
    };
}

/// Row 7: each file includes the next.
HostileCase chain_of_files(const std::string& name, int length, int code, const std::string& says) {
    return {name, code, says,
            [=](const Folder& folder) {
                for (int i = 0; i < length; ++i)
                    folder.write("a" + std::to_string(i) + ".xml",
                                 "<scene version=\"3.0.0\"><include filename=\"a" + std::to_string(i + 1) + ".xml\"/></scene>");
                folder.write("a" + std::to_string(length) + ".xml", "<scene version=\"3.0.0\"/>");
                return Arguments{"info", folder.write("scene.xml", scene_around("<include filename=\"a0.xml\"/>"))};
            }};
}

/// Row 7: two files with two inclusions each, so that what is read doubles with each.
HostileCase doubling_files() {
    return {"07-includes-that-double", 3, "",
            [](const Folder& folder) {
                for (int i = 0; i < 15; ++i) {
                    const std::string next = "<include filename=\"a" + std::to_string(i + 1) + ".xml\"/>";
                    folder.write("a" + std::to_string(i) + ".xml", "<scene version=\"3.0.0\">" + repeated(next, 8) + "</scene>");
                }
                folder.write("a15.xml", "<scene version=\"3.0.0\"><shape type=\"cube\"/></scene>");
                return Arguments{"info", folder.write("scene.xml", scene_around("<include filename=\"a0.xml\"/>"))};
            }};
}

std::vector<HostileCase> numbers() {
    std::vector<HostileCase> cases;
    const std::vector<std::pair<std::string, std::string>> radii{
        {"nan", "not a finite number"}, {"inf", "not a finite number"},
        {"1e400", "range of double"},   {"0x10", "is not a number"},
        {"1,5", "is not a number"},     {"--3", "is not a number"},
        {"", "a number is missing"},    {std::string(10000, '9'), "range of double"}};
    for (const auto& [value, says] : radii) {
        const std::string body = "<shape type=\"sphere\"><float name=\"radius\" value=\"" + value + "\"/></shape>";
        cases.push_back(scene_with("08-number-" + (value.size() > 9 ? "long" : value.empty() ? "empty" : value), 3, says, body));
    }
    cases.push_back(cases[4]);
    cases.back().name += "-german";
    cases.back().environment = {{"LC_ALL", "de_DE.UTF-8"}};
    cases.push_back(scene_with("08-point-german", 0, "spheres", "<shape type=\"sphere\"><float name=\"radius\" value=\"1.5\"/></shape>"));
    cases.back().says = "";
    cases.back().environment = {{"LC_ALL", "de_DE.UTF-8"}};
    const auto matrix = [&](const std::string& name, int code, const std::string& says, const std::string& value) {
        cases.push_back(scene_with(
            name, code, says, "<shape type=\"cube\"><transform name=\"to_world\"><matrix value=\"" + value + "\"/></transform></shape>"));
    };
    matrix("09-matrix-singular", 3, "", "1 0 0 0 0 1 0 0 0 0 0 0 0 0 0 1");
    matrix("09-matrix-nan", 3, "finite", "1 0 0 0 0 1 0 0 0 0 nan 0 0 0 0 1");
    matrix("09-matrix-mirror", 0, "", "-1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
    matrix("09-matrix-perspective", 3, "", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 1 1");
    matrix("09-matrix-short", 3, "", "1 0 0");
    const auto sensor = [&](const std::string& name, int code, const std::string& says, const std::string& inside) {
        cases.push_back({name, code, says,
                         [=](const Folder& folder) {
                             return Arguments{
                                 "info",
                                 folder.write("scene.xml", "<scene version=\"3.0.0\"><shape type=\"cube\"/><sensor type=\"perspective\">" +
                                                               inside + "</sensor></scene>")};
                         }});
    };
    const auto look = [](const std::string& rest) {
        return "<transform name=\"to_world\"><lookat origin=\"0, 0, 9\" " + rest + "/></transform>";
    };
    sensor("10-look-at-itself", 3, "", look("target=\"0, 0, 9\" up=\"0, 1, 0\""));
    sensor("10-look-along-up", 0, "", look("target=\"0, 0, 0\" up=\"0, 0, 1\""));
    for (const std::string fov : {"0", "180", "-1"})
        sensor("11-fov-" + fov, 3, "fov must lie", "<float name=\"fov\" value=\"" + fov + "\"/>");
    const auto size = [](const std::string& wide, const std::string& high) {
        return "<film type=\"hdrfilm\"><integer name=\"width\" value=\"" + wide + "\"/><integer name=\"height\" value=\"" + high +
               "\"/></film>";
    };
    sensor("11-film-0", 3, "width must be", size("0", "16"));
    sensor("11-film--1", 3, "height must be", size("16", "-1"));
    sensor("11-film-1x1", 0, "", size("1", "1"));
    cases.push_back({"11-film-1e12-pixels", 5, "", [=](const Folder& folder) {
                         const std::string text = "<scene version=\"3.0.0\"><shape type=\"cube\"/><sensor type=\"perspective\">" +
                                                  size("1000000", "1000000") + "</sensor></scene>";
                         return Arguments{"render", folder.write("scene.xml", text), "-o", (folder / "a.exr").string()};
                     }});
    return cases;
}

std::vector<HostileCase> values() {
    const auto material = [](const std::string& name, int code, const std::string& says, const std::string& type,
                             const std::string& inside) {
        return scene_with(name, code, says, "<shape type=\"cube\"><bsdf type=\"" + type + "\">" + inside + "</bsdf></shape>");
    };
    const auto number = [](const std::string& name, const std::string& value) {
        return "<float name=\"" + name + "\" value=\"" + value + "\"/>";
    };
    return {
        material("33-albedo--1", 3, "must not be negative", "diffuse", "<rgb name=\"reflectance\" value=\"-1\"/>"),
        material("33-albedo-2", 0, "must lie in [0, 1]", "diffuse", "<rgb name=\"reflectance\" value=\"2\"/>"),
        material("33-albedo-nan", 3, "finite", "diffuse", "<rgb name=\"reflectance\" value=\"nan\"/>"),
        material("33-roughness-0", 0, "", "roughconductor", number("alpha", "0")),
        material("33-roughness--1", 3, "", "roughconductor", number("alpha", "-1")),
        material("33-index-0", 3, "", "dielectric", number("int_ior", "0")),
        material("33-index-1", 0, "", "dielectric", number("int_ior", "1") + number("ext_ior", "1")),
        material("33-index-nan", 3, "", "dielectric", number("int_ior", "nan")),
        material("33-exponent-1e9", 0, "", "phong", number("exponent", "1e9")),
        material("33-exponent--1", 3, "", "phong", number("exponent", "-1")),
        material("33-spectrum-unsorted", 3, "must increase", "diffuse", "<spectrum name=\"reflectance\" value=\"500:0.5, 400:0.5\"/>"),
        material("33-spectrum-of-one", 3, "at least two", "diffuse", "<spectrum name=\"reflectance\" value=\"400:0.5\"/>"),
        scene_with("34-no-emitter", 0, "", ""),
        reads("34-no-shape", 0, "", "scene.xml", [] { return "<scene version=\"3.0.0\"><sensor type=\"perspective\"/></scene>"; }),
        reads("35-emitters-1e5", 0, "", "scene.xml",
              [] {
                  return scene_around(repeated("<emitter type=\"point\"><point name=\"position\" value=\"1, 2, 3\"/></emitter>\n", 100000));
              }),
        reads("35-materials-1e5", 0, "", "scene.xml",
              [] { return scene_around(repeated("<shape type=\"rectangle\"><bsdf type=\"diffuse\"/></shape>\n", 100000)); }),
        reads("35-spheres-2e4", 0, "of 80 triangles", "scene.xml",
              [] { return scene_around(repeated("<shape type=\"sphere\"/>\n", 20000)); }),
        scene_with("38-name-of-escapes", 3, "\\x1b[31m", "<shape type=\"cube\"><ref id=\"&#27;[31m\"/></shape>"),
        scene_with("38-name-of-64-kb", 3, "", "<shape type=\"cube\" id=\"a\"/><ref id=\"" + std::string(64000, 'x') + "\"/>"),
        scene_with("38-name-of-formats", 3, "%n%s{}", "<shape type=\"cube\"><ref id=\"%n%s{}\"/></shape>"),
    };
}

}  // namespace

std::vector<HostileCase> hostile_scenes() {
    std::vector<HostileCase> cases = files();
    for (const auto& more : {texts(), numbers(), values()}) cases.insert(cases.end(), more.begin(), more.end());
    cases.push_back(chain_of_files("07-include-10-deep", 10, 0, ""));
    cases.push_back(chain_of_files("07-include-100-deep", 100, 3, "too many files"));
    cases.push_back(doubling_files());
    return cases;
}

}  // namespace pencil_test
