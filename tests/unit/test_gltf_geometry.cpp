// Nodes and meshes of glTF files against numbers worked out by hand.
#include <cmath>

#include "unit/gltf_fixture.h"

namespace pencil::test {
namespace {

class GltfGeometry : public GltfTest {};

TEST_F(GltfGeometry, ATriangle) {
    GltfBuilder builder;
    builder.triangle();
    const Scene scene = load(builder);
    ASSERT_EQ(scene.triangles.size(), 1U);
    EXPECT_EQ(scene.positions, (std::vector<glm::dvec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(scene.normals[0], glm::vec3(0));  // flat without normals
    EXPECT_EQ(scene.uvs[2], glm::vec2(0, 1));
    EXPECT_TRUE(scene.colours.empty());
    ASSERT_EQ(scene.shapes.size(), 1U);
    EXPECT_EQ(scene.shapes[0].kind, "gltf");
    EXPECT_FALSE(scene.shapes[0].emits);
}

TEST_F(GltfGeometry, BinaryAndTextAreTheSameScene) {
    GltfBuilder builder;
    builder.material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture(builder, png(1, 1, 3, {9, 8, 7}))}}}}}});
    const Scene text = load_scene(write("a.gltf", builder.gltf())), binary = load_scene(write("a.glb", builder.glb()));
    EXPECT_EQ(text.positions, binary.positions);
    EXPECT_EQ(text.uvs, binary.uvs);
    ASSERT_EQ(text.textures.size(), 1U);
    ASSERT_EQ(binary.textures.size(), 1U);
    EXPECT_EQ(text.textures[0].texels, binary.textures[0].texels);
    EXPECT_EQ(text.materials[0].albedo_texture, binary.materials[0].albedo_texture);
    EXPECT_EQ(text.sensor.to_world, binary.sensor.to_world);
}

TEST_F(GltfGeometry, FilesBesideIt) {
    GltfBuilder builder;
    builder.triangle();
    write("a b.bin", builder.bin);
    builder.json["buffers"] = {{{"byteLength", builder.bin.size()}, {"uri", "a%20b.bin"}}};
    builder.bin.clear();
    EXPECT_EQ(load(builder).triangles.size(), 1U);
}

TEST_F(GltfGeometry, NodesAreTransformedByTheirParents) {
    GltfBuilder builder;
    builder.triangle();  // node 0
    const double half = std::sqrt(0.5);
    builder.json["nodes"][0].update({{"translation", {1, 2, 3}}, {"rotation", {0, 0, half, half}}, {"scale", {2, 1, 1}}});
    builder.add("nodes", {{"children", {0}}, {"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1}}});
    builder.json["scenes"] = {{{"nodes", {1}}}};
    const Scene scene = load(builder);
    expect_near(scene.positions[0], {11, 2, 3}, 1e-12);
    expect_near(scene.positions[1], {11, 4, 3}, 1e-12);  // twice as long, then a quarter turn from x to y
    expect_near(scene.positions[2], {10, 2, 3}, 1e-12);
}

TEST_F(GltfGeometry, MirroringKeepsTheFront) {
    GltfBuilder builder;
    builder.triangle();
    builder.json["nodes"][0]["scale"] = {-1, 1, 1};
    EXPECT_GT(face_vector(load(builder), 0).z, 0);
}

TEST_F(GltfGeometry, OneMeshAtTwoNodesIsTwoShapes) {
    GltfBuilder builder;
    builder.triangle();
    builder.add("nodes", {{"mesh", 0}, {"translation", {0, 0, 5}}, {"name", "second"}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.shapes.size(), 2U);
    EXPECT_EQ(scene.shapes[1].id, "second");
    EXPECT_EQ(scene.triangles[1].shape, 1U);
    EXPECT_EQ(scene.materials.size(), 1U);
}

TEST_F(GltfGeometry, OnlyTheDefaultSceneIsRead) {
    GltfBuilder builder;
    builder.triangle();
    builder.triangle();
    builder.json["scenes"] = {{{"nodes", {0, 1}}}, {{"nodes", {1}}}};
    builder.json["scene"] = 1;
    const Scene scene = load(builder);
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_TRUE(has_warning(scene, "more than one scene"));
}

/// Corners of the triangles of a primitive of five vertices, in the x coordinates 0 .. 4.
std::vector<glm::uvec3> corners_of(const Scene& scene) {
    std::vector<glm::uvec3> result;
    for (const Triangle3& t : scene.triangles)
        result.emplace_back(scene.positions[t.corners.x].x, scene.positions[t.corners.y].x, scene.positions[t.corners.z].x);
    return result;
}

GltfBuilder five_vertices(int mode, const std::vector<std::uint16_t>& indices) {
    GltfBuilder builder;
    GltfBuilder::Json primitive = {{"attributes", {{"POSITION", builder.floats({0, 0, 0, 1, 1, 0, 2, 0, 0, 3, 1, 0, 4, 0, 0}, "VEC3")}}},
                                   {"mode", mode}};
    if (!indices.empty()) primitive["indices"] = builder.accessor(indices, "SCALAR", 5123);
    builder.add("nodes", {{"mesh", builder.mesh(primitive)}});
    return builder;
}

TEST_F(GltfGeometry, ModesOfTriangles) {
    using Corners = std::vector<glm::uvec3>;
    EXPECT_EQ(corners_of(load(five_vertices(4, {}))), (Corners{{0, 1, 2}}));
    EXPECT_EQ(corners_of(load(five_vertices(4, {4, 3, 2, 0, 1, 2}))), (Corners{{4, 3, 2}, {0, 1, 2}}));
    EXPECT_EQ(corners_of(load(five_vertices(5, {}))), (Corners{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}}));
    EXPECT_EQ(corners_of(load(five_vertices(5, {4, 3, 2, 1}))), (Corners{{4, 3, 2}, {3, 1, 2}}));
    EXPECT_EQ(corners_of(load(five_vertices(6, {1, 0, 4, 3}))), (Corners{{0, 4, 1}, {4, 3, 1}}));
    EXPECT_TRUE(has_warning(load(five_vertices(4, {})), "lacks corners"));
}

TEST_F(GltfGeometry, PointsAndLinesAreLeftOut) {
    GltfBuilder builder = five_vertices(0, {});
    EXPECT_NE(message_of(builder.gltf()).find("no triangles"), std::string::npos);
    builder.triangle();
    const Scene scene = load(builder);
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_TRUE(has_warning(scene, "points and lines are left out"));
}

TEST_F(GltfGeometry, NormalsAndColours) {
    GltfBuilder builder;
    const float nan = std::nanf("");
    builder.triangle();
    auto& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["NORMAL"] = builder.floats({0, 0, 1, 0, 0, nan, 0, 0.6F, 0.8F}, "VEC3");
    attributes["COLOR_0"] = builder.accessor<std::uint8_t>({255, 0, 51, 255, 0, 0, 0, 255, 255, 255, 255, 255}, "VEC4", 5121, true);
    const Scene scene = load(builder);
    EXPECT_EQ(scene.normals[1], glm::vec3(0));
    EXPECT_EQ(scene.normals[2], glm::vec3(0, 0.6F, 0.8F));
    EXPECT_TRUE(has_warning(scene, "1 normals that are not finite"));
    ASSERT_EQ(scene.colours.size(), 3U);
    EXPECT_EQ(scene.colours[0], glm::vec3(1, 0, 0.2F));
    ASSERT_EQ(scene.textures.size(), 1U);
    EXPECT_EQ(scene.textures[0].kind, Texture::Kind::vertex_colours);
    EXPECT_EQ(scene.materials[scene.triangles[0].material].albedo_texture, 0);
}

TEST_F(GltfGeometry, WhiteColoursAreNone) {
    GltfBuilder builder;
    builder.triangle();
    builder.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] =
        builder.accessor<std::uint8_t>(std::vector<std::uint8_t>(12, 255), "VEC4", 5121, true);
    EXPECT_TRUE(load(builder).colours.empty());
}

TEST_F(GltfGeometry, QuantizedAndInterleaved) {
    GltfBuilder builder;
    // Positions as 16-bit integers 12 bytes apart, texture coordinates as fractions of 255 between them.
    const std::vector<std::int16_t> rows = {0, 0, 0, 0, 0x7fff, 0, 30000, 0, 0, 0, 0x00ff, 0, -5, 7, 9, 0, 0x3300, 0};
    const int view = builder.view(GltfBuilder::raw(rows));
    builder.json["bufferViews"][0]["byteStride"] = 12;
    const int positions = builder.add("accessors", {{"bufferView", view}, {"componentType", 5122}, {"count", 3}, {"type", "VEC3"}});
    const int uvs = builder.add(
        "accessors",
        {{"bufferView", view}, {"byteOffset", 8}, {"componentType", 5121}, {"count", 3}, {"type", "VEC2"}, {"normalized", true}});
    builder.add("nodes",
                {{"mesh", builder.mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uvs}}}})}, {"scale", {0.5, 1, 1}}});
    builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.positions[1], glm::dvec3(15000, 0, 0));
    EXPECT_EQ(scene.positions[2], glm::dvec3(-2.5, 7, 9));
    EXPECT_EQ(scene.uvs[0], glm::vec2(1.0F, 127 / 255.0F));
    EXPECT_EQ(scene.uvs[2], glm::vec2(0, 0.2F));
}

TEST_F(GltfGeometry, SparseAccessors) {
    GltfBuilder builder;
    builder.triangle();
    const int indices = builder.view(GltfBuilder::raw<std::uint16_t>({1, 2})),
              values = builder.view(GltfBuilder::raw<float>({5, 0, 0, 0, 6, 0}));
    builder.json["accessors"][0]["sparse"] = {
        {"count", 2}, {"indices", {{"bufferView", indices}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
    EXPECT_EQ(load(builder).positions, (std::vector<glm::dvec3>{{0, 0, 0}, {5, 0, 0}, {0, 6, 0}}));
    builder.json["accessors"][0].erase("bufferView");  // zeros otherwise
    EXPECT_EQ(load(builder).positions, (std::vector<glm::dvec3>{{0, 0, 0}, {5, 0, 0}, {0, 6, 0}}));
}

TEST_F(GltfGeometry, WhatMovesStandsStill) {
    GltfBuilder builder;
    builder.triangle();
    builder.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
    builder.json["nodes"][0]["skin"] = 0;
    builder.json["skins"] = {{{"joints", {0}}}};
    builder.json["animations"] = {{{"channels", GltfBuilder::Json::array()}, {"samplers", GltfBuilder::Json::array()}}};
    const Scene scene = load(builder);
    for (const char* part : {"animations are left out", "morph targets are left out", "skins are left out"})
        EXPECT_TRUE(has_warning(scene, part)) << part;
}

}  // namespace
}  // namespace pencil::test
