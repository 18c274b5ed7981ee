// Scene files as text: encodings, line ends, what is said twice or in the wrong place.
#include <glm/geometric.hpp>

#include "unit/scene_fixture.h"

namespace pencil::test {
namespace {

using SceneText = SceneTest;

TEST_F(SceneText, EncodingsAndLineEnds) {
    std::string text = in_scene("<!-- \xc3\xbc --><shape type=\"cube\" id=\"\xc3\xbc\"/>\n");
    EXPECT_EQ(load_text("\xEF\xBB\xBF" + text).shapes.at(0).id, "\xc3\xbc");
    std::string crlf;
    for (const char c : text + "x") crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
    crlf.pop_back();
    EXPECT_EQ(load_text("<?xml version=\"1.0\"?>\r\n" + crlf).shapes.size(), 1U);
}

TEST_F(SceneText, OtherEncodingsThanUtf8) {
    write(
        "K\xc3\xbc"
        "che.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const std::string before = "<!-- ", after = " -->" + in_scene(
                                                             "<shape type=\"obj\"><string name=\"filename\" value=\"K\xfc"
                                                             "che.obj\"/></shape>");
    EXPECT_EQ(load_text(before +
                        "K\xfc"
                        "che" +
                        after)
                  .triangles.size(),
              1U)
        << "Latin-1";
    for (const bool big_endian : {false, true}) {
        std::string utf16 = big_endian ? "\xfe\xff" : "\xff\xfe";
        for (const char c : before + after) {
            const char pair[2] = {big_endian ? '\0' : c, big_endian ? c : '\0'};
            utf16.append(pair, 2);
        }
        EXPECT_EQ(load_text(utf16).triangles.size(), 1U) << "UTF-16, " << big_endian;
    }
}

/// Mitsuba 0.x warns and goes on.
TEST_F(SceneText, WhatOldFilesSayTwiceCountsAsSaidLast) {
    const std::string twice = "<shape type=\"sphere\"><float name=\"radius\" value=\"1\"/><float name=\"radius\" value=\"3\"/></shape>";
    std::string old = in_scene(twice);
    old.replace(old.find("3.0.0"), 5, "0.6.0");
    const Scene scene = load_text(old);
    EXPECT_NEAR(glm::length(scene.positions[0]), 3, 1e-6);
    EXPECT_TRUE(has_warning(scene, "given twice"));
}

TEST_F(SceneText, ElementsBesideObjectsHaveNoEffect) {
    const Scene scene = load_body(
        "<boolean name=\"robust\" value=\"true\"/><sampler type=\"independent\"/><film type=\"hdrfilm\" id=\"f\"/>"
        "<shape type=\"cube\"/>");
    EXPECT_EQ(scene.triangles.size(), 12U);
    EXPECT_TRUE(has_warning(scene, "<boolean> directly inside <scene> has no effect"));
    EXPECT_EQ(scene.warnings.size(), 2U);
}

}  // namespace
}  // namespace pencil::test
