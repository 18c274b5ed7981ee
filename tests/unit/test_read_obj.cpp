// The OBJ reader: every form of index, and every defect with its line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/meshes/read_obj.h"
#include "unit/mesh_defect.h"
#include "util/error.h"

namespace pencil {
namespace {

std::string defect(const std::string& text) {
    return defect_of([](const std::string& content) { read_obj(content, "m.obj"); }, text);
}

void expect_defect(const std::string& text, const std::string& where, const std::string& part) {
    expect_message(defect(text), where, part);
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(ReadObj, TriangleAndQuad) {
    const Mesh mesh = read_obj(square + "f 1 2 3 4\n", "m.obj");
    ASSERT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
    ASSERT_EQ(mesh.triangles.size(), 2U);
    EXPECT_EQ(mesh.triangles[0], glm::uvec3(0, 1, 2));
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 2, 3));
    EXPECT_TRUE(mesh.normals.empty());
}

TEST(ReadObj, AllIndexFormsNameTheSameCorners) {
    const std::string tables = square + "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 0 2\n";
    for (const char* face : {"f 1/1 2/2 3/1", "f 1//1 2//1 3//1", "f 1/1/1 2/2/1 3/1/2", "f -4 -3 -2", "f -4//-2 -3//-2 -2//-1",
                             "f -4/-2/-2 -3/-1/-2 -2/-2/-1", "f\t1 2  3 # comment", "f +1 2 3"}) {
        const Mesh mesh = read_obj(tables + face, "m.obj");
        ASSERT_EQ(mesh.triangles.size(), 1U) << face;
        EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0)) << face;
        EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0)) << face;
        EXPECT_EQ(mesh.normals.empty(),
                  std::string(face).find("//") == std::string::npos && std::count(face, face + std::strlen(face), '/') < 6)
            << face;
    }
}

TEST(ReadObj, CornersWithDifferentNormalsAreDifferentVertices) {
    const Mesh mesh = read_obj(square + "vn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//2 2//1 4\n", "m.obj");
    ASSERT_EQ(mesh.positions.size(), 5U);  // corner 1 twice; corner 4 without normal
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(3, 1, 4));
    EXPECT_EQ(mesh.normals[3], glm::dvec3(1, 0, 0));
    EXPECT_EQ(mesh.normals[4], glm::dvec3(0));
}

TEST(ReadObj, OtherStatementsAreSkipped) {
    const std::string text =
        "# c\r\nmtllib ../../etc/passwd\r\no a b\r\ng\r\ns off\r\nusemtl x\r\nv 0 0 0 1\r\nv 1 0 0 .5 .5 .5\r\n"
        "v 0 1 0\r\nl 1 2\r\n\r\n  f 1 2 3\r\nsomething new";
    EXPECT_EQ(read_obj(text, "m.obj").triangles.size(), 1U);
}

TEST(ReadObj, EmptyFileAndNoFacesAreEmptyMeshes) {
    EXPECT_TRUE(read_obj("", "m.obj").triangles.empty());
    EXPECT_TRUE(read_obj(square, "m.obj").triangles.empty());
}

TEST(ReadObj, BadIndices) {
    expect_defect(square + "f 0 1 2", "m.obj:5: ", "indices start at 1");
    expect_defect(square + "\nf 1 2 5", "m.obj:6: ", "names vertex 5, but there are 4 so far");
    expect_defect(square + "f 1 2 -5", "m.obj:5: ", "-5");
    expect_defect(square + "f 1 2 2147483648", "m.obj:5: ", "2147483648");
    expect_defect(square + "f 1 2 9223372036854775808", "m.obj:5: ", "is not an index");
    expect_defect(square + "f 1 2 -9223372036854775808", "m.obj:5: ", "names vertex");
    expect_defect(square + "f 1 2 4294967297", "m.obj:5: ", "4294967297");
    expect_defect(square + "f 1/2/3/4 2 3", "m.obj:5: ", "more than three indices");
    expect_defect(square + "f 1 2 3.5", "m.obj:5: ", "is not an index");
    expect_defect(square + "f 1 2 x", "m.obj:5: ", "\"x\" is not an index");
    expect_defect(square + "f /1 2 3", "m.obj:5: ", "is not an index");
    expect_defect("f 1 2 3\n" + square, "m.obj:1: ", "0 so far");
}

TEST(ReadObj, BadNumbersAndCounts) {
    expect_defect("v 0 0", "m.obj:1: ", "v has 2 numbers, not 3");
    expect_defect("v 0 0 0\nv 1 2 3 4 5 6 7 8", "m.obj:2: ", "more than 7");
    expect_defect("v 0 nano 0", "m.obj:1: ", "\"nano\" is not a finite number");
    expect_defect("v 0 1e400 0", "m.obj:1: ", "range");
    expect_defect("v 0 1,5 0", "m.obj:1: ", "decimal mark");
    expect_defect("v 0x10 0 0", "m.obj:1: ", "\"0x10\" is not a number");
    expect_defect("v --3 0 0", "m.obj:1: ", "\"--3\" is not a number");
    expect_defect("v 0 0 0\nvn 0 1", "m.obj:2: ", "vn has 2 numbers");
    expect_defect("v 0 0 0\nvn 0 1 x", "m.obj:2: ", "\"x\" is not a number");
    expect_defect(square + "f 1 2 \\\n\\\n9 \\", "m.obj:7: ", "names vertex 9");
    expect_defect(square + "f 1 2 \\", "m.obj:5: ", "is not an index");
    expect_defect("hello world\n", "m.obj: ", "is it an OBJ file?");
    expect_defect(std::string("\x89PNG\r\n\0\0\0\rIHDR", 14), "m.obj:2: ", "binary");
    EXPECT_EQ(defect("v \x1b[31m 0 0").find('\x1b'), std::string::npos);
}

TEST(ReadObj, MarksOfEncodings) {
    const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::string little = "\xff\xfe", big = "\xfe\xff";
    for (const char c : text) {
        little += {c, '\0'};
        big += {'\0', c};
    }
    for (const std::string& bytes : {little, big, "\xef\xbb\xbf" + text}) {
        const Mesh mesh = read_obj(bytes, "m.obj");
        ASSERT_EQ(mesh.triangles.size(), 1U);
        EXPECT_EQ(mesh.positions[1], glm::dvec3(1, 0, 0));
    }
}

TEST(ReadObj, LinesGoOnAfterBackslashes) {
    const Mesh mesh = read_obj(square + "f 1 \\\r\n  2 \\\n3\n# a comment does not \\\nf 1 3 4\n", "m.obj");
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(ReadObj, NormalsThatAreNoNumbersAreLeftOut) {
    const Mesh mesh = read_obj(square + "vn nan nan nan\nvn 0 0 1\nvn -nan(ind) 0 1\nf 1//1 2//2 3//3\n", "m.obj");
    EXPECT_EQ(mesh.normals, (std::vector<glm::dvec3>{{0, 0, 0}, {0, 0, 1}, {0, 0, 0}}));
    ASSERT_EQ(mesh.notes.size(), 1U);
    EXPECT_NE(mesh.notes[0].find("2 normals"), std::string::npos);
}

void expect_note(const Mesh& mesh, const std::string& part) {
    ASSERT_EQ(mesh.notes.size(), 1U);
    EXPECT_NE(mesh.notes[0].find(part), std::string::npos) << mesh.notes[0];
}

/// What programs write by mistake costs no more than it must.
TEST(ReadObj, FacesThatCannotBeShownAreLeftOut) {
    const Mesh thin = read_obj(square + "f\nf 1\nf 1 2\nf 1 2 3\n", "m.obj");
    EXPECT_EQ(thin.triangles.size(), 1U);
    expect_note(thin, "3 faces of fewer than 3 corners");
    const Mesh nowhere = read_obj(square + "v nan 0 0\nv 1 -inf 0\nv 0 1.#QNAN 0\nf 1 2 5\nf 6 2 3 4\nf 1 2 3 7\nf 1 3 4\n", "m.obj");
    EXPECT_EQ(nowhere.triangles.size(), 1U);
    for (const glm::dvec3& p : nowhere.positions) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    expect_note(nowhere, "3 faces with vertices that are nowhere");
}

TEST(ReadObj, WhatFacesNameAndTheFileLacksIsNone) {
    const Mesh mesh = read_obj(square + "vt 0.5 0.5\nf 1/1/1 2/2/1 3/1/1\n", "m.obj");
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_EQ(mesh.uvs, (std::vector<glm::vec2>{{0.5F, 0.5F}, {0, 0}, {0.5F, 0.5F}}));
    expect_note(mesh, "4 texture coordinates or normals");
}

/// Twice the area that the triangles cover, those turned over counted as negative.
double signed_area(const Mesh& mesh) {
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a = mesh.positions[t.y] - mesh.positions[t.x], b = mesh.positions[t.z] - mesh.positions[t.x];
        const double area = a.x * b.y - a.y * b.x;
        EXPECT_GE(area, 0);
        sum += area;
    }
    return sum;
}

TEST(ReadObj, ConcavePolygonsAreCutAsTheyAre) {
    // An L, a dart, and a comb, each begun at a corner from which a fan would cover the outside.
    EXPECT_EQ(signed_area(read_obj("v 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 1 2 3 4 5 6\n", "m.obj")), 6);
    EXPECT_EQ(signed_area(read_obj("v 4 0 0\nv 1 1 0\nv 0 4 0\nv 0 0 0\nf 1 2 3 4\n", "m.obj")), 8);
    std::string comb, face = "f";
    for (int i = 0; i < 20; ++i) comb += "v " + std::to_string(20 - i) + (i % 2 == 0 ? " 9 0\n" : " 1 0\n");
    comb += "v 0 0 0\nv 20 0 0\n";
    for (int i = 1; i <= 22; ++i) face += " " + std::to_string(i);
    double outline = 0;
    const Mesh mesh = read_obj(comb + face + "\n", "m.obj");
    ASSERT_EQ(mesh.triangles.size(), 20U);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 a = mesh.positions[i], b = mesh.positions[(i + 1) % mesh.positions.size()];
        outline += a.x * b.y - a.y * b.x;
    }
    EXPECT_NEAR(signed_area(mesh), outline, 1e-9);
}

TEST(ReadObj, LargePolygonsAndLongLines) {
    std::string text, face = "f";
    constexpr int corners = 100000;
    for (int i = 1; i <= corners; ++i) {
        text += "v " + std::to_string(i) + " 0 0\n";
        face += " " + std::to_string(i);
    }
    EXPECT_EQ(read_obj(text + face, "m.obj").triangles.size(), static_cast<std::size_t>(corners - 2));
    EXPECT_NE(defect("v 0 0 " + std::string(1 << 20, '7') + "x"), "");
}

TEST(ReadObj, TruncationNeverCrashes) {
    const std::string text = square + "vn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\nf -4 -3 -2 -1\n";
    for (std::size_t n = 0; n < text.size(); ++n) defect(text.substr(0, n));
}

}  // namespace
}  // namespace pencil
