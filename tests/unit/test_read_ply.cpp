// The PLY reader: one mesh in three encodings, and headers and bodies that lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "scene/meshes/read_ply.h"
#include "unit/mesh_defect.h"
#include "util/error.h"

namespace pencil {
namespace {

std::string ply_defect(const std::string& bytes) {
    return defect_of([](const std::string& content) { read_ply(content, "m.ply"); }, bytes);
}

void expect_ply_defect(const std::string& bytes, const std::string& where, const std::string& part) {
    expect_message(ply_defect(bytes), where, part);
}

template <class T>
std::string raw(T value, bool big) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    if (big) std::reverse(bytes, bytes + sizeof(T));  // the tests run on little-endian machines
    return {bytes, sizeof(T)};
}

std::string header(const std::string& format, int vertices, int faces) {
    return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + std::to_string(vertices) +
           "\nproperty float x\nproperty double y\nproperty float z\nproperty uchar red\nelement face " + std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nproperty short flag\nend_header\n";
}
const std::string ascii_body = "0 0 0 255\n1 0 0 255\n1 1 0 255\n\n0 1 0 255\n4 0 1 2 3 -7\n3 0 1 2 7\n";

std::string binary(bool big) {
    const double positions[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian", 4, 2);
    for (const auto& p : positions)
        bytes += raw(static_cast<float>(p[0]), big) + raw(p[1], big) + raw(static_cast<float>(p[2]), big) + '\xff';
    bytes += '\x04';
    for (std::int32_t i = 0; i < 4; ++i) bytes += raw(i, big);
    bytes += raw(std::int16_t{-7}, big) + '\x03';
    for (std::int32_t i = 0; i < 3; ++i) bytes += raw(i, big);
    return bytes + raw(std::int16_t{7}, big);
}

void expect_square(const Mesh& mesh) {
    ASSERT_EQ(mesh.positions.size(), 4U);
    EXPECT_EQ(mesh.positions[2], glm::dvec3(1, 1, 0));
    ASSERT_EQ(mesh.triangles.size(), 3U);
    EXPECT_EQ(mesh.triangles[1], glm::uvec3(0, 2, 3));
    EXPECT_EQ(mesh.triangles[2], glm::uvec3(0, 1, 2));
    EXPECT_TRUE(mesh.normals.empty());
}

TEST(ReadPly, ThreeEncodingsOneMesh) {
    expect_square(read_ply(header("ascii", 4, 2) + ascii_body, "m.ply"));
    expect_square(read_ply(binary(false), "m.ply"));
    expect_square(read_ply(binary(true), "m.ply"));
}

/// An arrow head, whose fan from the first corner would leave it.
TEST(ReadPly, ConcavePolygonsAreCutAsTheyAre) {
    const std::string vertices = "0 0 0\n1 2 0\n0 1 0\n-1 2 0\n", xyz = "property float x\nproperty float y\nproperty float z\n";
    const std::string element = "element vertex 4\n" + xyz, face = "element face 1\nproperty list uchar int vertex_indices\n";
    const std::string start = "ply\nformat ascii 1.0\n";
    for (const std::string& text : {start + element + face + "end_header\n" + vertices + "4 1 2 3 0\n",
                                    start + face + element + "end_header\n4 1 2 3 0\n" + vertices}) {
        const Mesh mesh = read_ply(text, "m.ply");
        ASSERT_EQ(mesh.triangles.size(), 2U);
        double area = 0;
        for (const glm::uvec3& t : mesh.triangles) {
            const glm::dvec3 a = mesh.positions[t.y] - mesh.positions[t.x], b = mesh.positions[t.z] - mesh.positions[t.x];
            EXPECT_GT(a.x * b.y - a.y * b.x, 0);
            area += (a.x * b.y - a.y * b.x) / 2;
        }
        EXPECT_NEAR(area, 1, 1e-12);
    }
    const Mesh lost = read_ply(start + element + face + "end_header\n0 0 0\n1 nan 0\n0 1 0\n-1 2 0\n4 1 2 3 0\n", "m.ply");
    EXPECT_EQ(lost.notes.size(), 1U);
}

TEST(ReadPly, NormalsForeignElementsAndCarriageReturns) {
    const std::string text =
        "ply\r\nformat ascii 1.0\r\nobj_info x\r\nelement material 1\r\nproperty list uint float shine\r\nproperty int8 k\r\n"
        "element face 1\r\nproperty list uint8 uint32 vertex_index\r\nelement vertex 3\r\nproperty float64 z\r\n"
        "property float32 nx\r\nproperty float ny\r\nproperty float nz\r\nproperty float x\r\nproperty float y\r\nend_header\r\n"
        "2 0.5 1e3 7\r\n3 2 1 0\r\n9 0 0 1 7 8\r\n9 0 0 1 7 9\r\n9 0 1 0 8 8";
    const Mesh mesh = read_ply(text, "m.ply");
    EXPECT_EQ(mesh.positions.at(0), glm::dvec3(7, 8, 9));
    EXPECT_EQ(mesh.normals.at(2), glm::dvec3(0, 1, 0));
    EXPECT_EQ(mesh.triangles.at(0), glm::uvec3(2, 1, 0));
}

TEST(ReadPly, ColoursOfVertices) {
    const Mesh bytes = read_ply(header("ascii", 0, 0), "m.ply");
    EXPECT_TRUE(bytes.colours.empty());
    const auto coloured = [](const std::string& type, const std::string& colour) {
        const std::string p = "\nproperty " + type + " ";
        const std::string text = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z" + p +
                                 "red" + p + "green" + p + "blue\nend_header\n0 0 0 " + colour + "\n";
        return read_ply(text, "m.ply").colours.at(0);
    };
    EXPECT_EQ(coloured("uchar", "255 0 0"), glm::vec3(1, 0, 0));
    EXPECT_NEAR(coloured("uchar", "128 0 0").x, 0.21586F, 1e-5);  // by the curve of sRGB
    EXPECT_EQ(coloured("ushort", "0 65535 0"), glm::vec3(0, 1, 0));
    EXPECT_EQ(coloured("float", "0.5 7 -1"), glm::vec3(0.5F, 1, 0));
}

TEST(ReadPly, StripsOfTriangles) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
        "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 4 3 2\n";
    EXPECT_EQ(read_ply(text, "m.ply").triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {2, 1, 3}, {4, 3, 2}}));
    std::string bad = text;
    bad.replace(bad.find("-1 4"), 4, "-2 4");
    expect_ply_defect(bad, "m.ply:15: ", "out of range");
}

TEST(ReadPly, TextureCoordinatesOfFacesAreLeftOutAloud) {
    const std::string text =
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n"
        "3 0 1 2 6 0 0 1 0 0 1\n";
    const Mesh mesh = read_ply(text, "m.ply");
    EXPECT_EQ(mesh.triangles.size(), 1U);
    ASSERT_EQ(mesh.notes.size(), 1U);
    EXPECT_NE(mesh.notes[0].find("texture coordinates of faces"), std::string::npos);
}

TEST(ReadPly, EmptyMeshes) {
    EXPECT_TRUE(read_ply(header("ascii", 0, 0), "m.ply").triangles.empty());
    EXPECT_TRUE(read_ply(header("binary_big_endian", 0, 0), "m.ply").triangles.empty());
}

TEST(ReadPly, CountsAreCheckedBeforeAnythingIsAllocated) {
    for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        const auto counted = [&](const std::string& count) {
            return "ply\nformat " + format + " 1.0\nelement vertex " + count +
                   "\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n";
        };
        expect_ply_defect(counted("1000000000"), "m.ply:3: ", "the file ends too early");
        expect_ply_defect(counted("9223372036854775807"), "m.ply:3: ", "the file ends too early");
        expect_ply_defect(counted("9223372036854775808"), "m.ply:3: ", "is not a number of things");
        expect_ply_defect(counted("-1"), "m.ply:3: ", "is not a number of things");
        expect_ply_defect("ply\nformat " + format +
                              " 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                              "element nothing 9223372036854775807\nend_header\n",
                          "m.ply:7: ", "has no properties");
    }
}

TEST(ReadPly, BadHeaders) {
    expect_ply_defect("", "m.ply:1: ", "end_header");
    expect_ply_defect("plx\n", "m.ply:1: ", "the first line is not \"ply\"");
    expect_ply_defect("ply\nformat ascii 2.0\nend_header\n", "m.ply:2: ", "ENCODING 1.0");
    expect_ply_defect("ply\nformat binary_middle_endian 1.0\nend_header\n", "m.ply:2: ", "is not known");
    expect_ply_defect("ply\nend_header\n", "m.ply:2: ", "no format line");
    expect_ply_defect("ply\nformat ascii 1.0\nend_header\n", "m.ply: ", "no element \"vertex\"");
    expect_ply_defect("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n0 0\n",
                      "m.ply:3: ", "x, y and z");
    expect_ply_defect("ply\nformat ascii 1.0\nelement vertex 1\nproperty half x\nend_header\n", "m.ply:4: ", "\"half\" is not known");
    expect_ply_defect("ply\nformat ascii 1.0\nproperty float x\n", "m.ply:3: ", "before the first element");
    expect_ply_defect("ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_indices\n", "m.ply:4: ", "must be an integer");
    expect_ply_defect("ply\nformat ascii 1.0\nelement vertex\n", "m.ply:3: ", "NAME COUNT");
    expect_ply_defect("ply\nformat ascii 1.0\n" + std::string(1 << 20, 'c') + "\nend_header\n", "m.ply:3: ", "65536 bytes");
    expect_ply_defect(header("ascii", 1, 0) + "0 0      \n", "m.ply:13: ", "too few values");
    std::string doubles = header("ascii", 4, 2) + ascii_body;
    doubles.replace(doubles.find("uchar int"), 9, "uchar double");
    expect_ply_defect(doubles, "m.ply:9: ", "vertex indices must be integers");
}

TEST(ReadPly, BadBodies) {
    const std::string head = header("ascii", 3, 1);
    expect_ply_defect(head + "0 0 0 1\n0 0 0 1\n0 0 0 1 5\n3 0 1 2 0\n", "m.ply:15: ", "more values than the header says");
    expect_ply_defect(head + "0 0 0 1\n0 1,5 0 1\n0 0 0 1\n3 0 1 2 0\n", "m.ply:14: ", "decimal mark");
    expect_ply_defect(head + "0 0 0 1\n0 0 0 1\n0 0 0 1\n3 0 1 3 0\n", "m.ply: ", "names vertex 3, but there are 3");
    expect_ply_defect(head + "0 0 0 1\n0 0 0 1\n0 0 0 1\n3 0 1 -1 0\n", "m.ply:16: ", "out of range");
    expect_ply_defect(head + "0 0 0 1\n0 0 0 1\n0 0 0 1\n4000000000 0 1 2 0\n", "m.ply:16: ", "impossible length");
    expect_ply_defect(head + "0 0 0 1\n0 0 0 1\n0 0 0 1\n-3 0 1 2 0\n", "m.ply:16: ", "impossible length");
    expect_ply_defect(head + "0 0 0 1\n0 0 0 1\n0 0 0 1\n3.5 0 1 2 0\n", "m.ply:16: ", "is not an integer");
    std::string bytes = binary(false);
    const std::size_t body = bytes.find("end_header\n") + 11;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    std::string bad = bytes;
    std::memcpy(&bad[body], &nan, sizeof nan);
    EXPECT_EQ(read_ply(bad, "m.ply").triangles.size(), 0U);
    bad = bytes;
    bad[body + 4 * 17 + 1 + 3] = '\x7f';  // the first face's first index becomes huge
    expect_ply_defect(bad, "m.ply: ", "names vertex 2130706432");
    std::string signed_length =
        "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list char int vertex_indices\nend_header\n\xff????";
    expect_ply_defect(signed_length, "m.ply: ", "impossible length");
}

const char* const plain_header =
    "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nproperty float quality\n"
    "element face 4\nproperty list uchar int vertex_indices\nend_header\n";

/// Scanners write NaN for what they did not see, and for what they did not measure.
TEST(ReadPly, WhatCannotBeShownIsLeftOut) {
    const std::string body = "0 0 0 nan\n1 0 0 1\n0 1 0 -inf\nnan 0 0 1\n5 5 5 1\n3 0 1 2\n3 0 1 3\n2 0 1\n3 1 2 4\n";
    const Mesh mesh = read_ply(plain_header + body, "m.ply");
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}, {1, 2, 4}}));
    ASSERT_EQ(mesh.notes.size(), 2U);
    EXPECT_NE(mesh.notes[0].find("1 faces of fewer than 3 corners"), std::string::npos) << mesh.notes[0];
    EXPECT_NE(mesh.notes[1].find("1 vertices are nowhere (NaN or infinite); the 1 triangles"), std::string::npos) << mesh.notes[1];
}

/// Of Rhino, and of old versions of Blender.
TEST(ReadPly, LinesOfCarriageReturnsAndCommentsWithoutTheWord) {
    std::string text = header("ascii", 4, 2) + ascii_body, bytes = binary(false);
    const Mesh expected = read_ply(text, "m.ply");
    const std::size_t end = bytes.find("end_header\n") + 11;
    std::replace(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(end), '\n', '\r');
    EXPECT_EQ(read_ply(bytes, "m.ply").triangles, expected.triangles);
    std::replace(text.begin(), text.end(), '\n', '\r');
    EXPECT_EQ(read_ply(text, "m.ply").positions, expected.positions);
    std::string remark = header("ascii", 4, 2) + ascii_body;
    remark.insert(remark.find("element"), "Created by a program\n");
    const Mesh mesh = read_ply(remark, "m.ply");
    EXPECT_EQ(mesh.triangles, expected.triangles);
    ASSERT_FALSE(mesh.notes.empty());
    EXPECT_NE(mesh.notes[0].find("begin with \"Created\""), std::string::npos) << mesh.notes[0];
}

TEST(ReadPly, TruncationNeverCrashes) {
    for (const std::string& bytes : {header("ascii", 4, 2) + ascii_body, binary(false), binary(true)})
        for (std::size_t n = 0; n + 2 < bytes.size(); ++n) EXPECT_NE(ply_defect(bytes.substr(0, n)), "") << n;
}

}  // namespace
}  // namespace pencil
