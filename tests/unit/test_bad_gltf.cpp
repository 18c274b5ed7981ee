// glTF files that lie: each index, range, count and name is refused with a message, and nothing is read beyond what is there.
#include "unit/gltf_fixture.h"

namespace pencil::test {
namespace {

class BadGltf : public GltfTest {
protected:
    using Json = GltfBuilder::Json;

    static GltfBuilder good() {
        GltfBuilder builder;
        builder.triangle();
        builder.json["meshes"][0]["primitives"][0]["indices"] = builder.accessor<std::uint16_t>({0, 1, 2}, "SCALAR", 5123);
        return builder;
    }
    /// The good file with the value at a JSON pointer replaced.
    void expect_refused(const char* pointer, const Json& value, const std::string& part) const {
        GltfBuilder builder = good();
        builder.json[Json::json_pointer(pointer)] = value;
        SCOPED_TRACE(std::string(pointer) + " = " + value.dump());
        expect_message(builder, part);
    }
};

TEST_F(BadGltf, TheGoodOneLoads) { EXPECT_EQ(load(good()).triangles.size(), 1U); }

TEST_F(BadGltf, IndicesOfLists) {
    expect_refused("/nodes/0/mesh", 1, "node 0 names mesh 1, but there are 1");
    expect_refused("/nodes/0/mesh", 2147483647, "names mesh 2147483647");
    expect_refused("/nodes/0/camera", 7, "names camera 7, but there are 0");
    expect_refused("/meshes/0/primitives/0/material", 3, "names material 3, but there are 0");
    expect_refused("/meshes/0/primitives/0/attributes/POSITION", 9, "names accessor 9");
    expect_refused("/meshes/0/primitives/0/attributes/POSITION", -2, "names accessor -2");
    expect_refused("/meshes/0/primitives/0/attributes/TEXCOORD_0", 99, "names accessor 99");
    expect_refused("/meshes/0/primitives/0/indices", 99, "");
    expect_refused("/accessors/0/bufferView", 77, "buffer view 77");
    expect_refused("/bufferViews/0/buffer", 5, "names buffer 5");
    expect_refused("/bufferViews/0/buffer", -1, "names buffer -1");
    expect_refused("/scenes", Json::array({{{"nodes", {12}}}}), "names node 12");
    expect_refused("/scene", 4, "names scene 4");
}

TEST_F(BadGltf, RangesOfBuffers) {
    expect_refused("/accessors/0/count", 4, "needs 4 elements");
    expect_refused("/accessors/0/count", std::uint64_t{1} << 62, "needs 4611686018427387904 elements");
    expect_refused("/accessors/0/count", std::numeric_limits<std::uint64_t>::max(), "needs 18446744073709551615 elements");
    expect_refused("/accessors/0/byteOffset", 4, "needs 3 elements");
    expect_refused("/accessors/0/byteOffset", std::numeric_limits<std::uint64_t>::max(), "needs 3 elements");
    expect_refused("/accessors/0/byteOffset", std::numeric_limits<std::uint64_t>::max() - 11, "needs 3 elements");
    expect_refused("/bufferViews/0/byteOffset", std::numeric_limits<std::uint64_t>::max() - 3, "beyond the end of its buffer");
    expect_refused("/bufferViews/0/byteLength", std::numeric_limits<std::uint64_t>::max(), "beyond the end of its buffer");
    expect_refused("/bufferViews/0/byteLength", 35, "needs 3 elements");
    expect_refused("/bufferViews/0/byteStride", 4, "lie only 4 apart");
    expect_refused("/bufferViews/0/byteStride", 252, "needs 3 elements");
}

TEST_F(BadGltf, TypesOfAccessors) {
    expect_refused("/accessors/0/type", "VEC2", "has 2 numbers for each element, not 3");
    expect_refused("/accessors/0/type", "MAT4", "has matrices");
    expect_refused("/accessors/0/type", "VEC9", "");
    expect_refused("/accessors/0/componentType", 5124, "unknown type 5124");
    expect_refused("/accessors/0/componentType", 5130, "unknown type 5130");
    expect_refused("/accessors/2/componentType", 5122, "does not hold unsigned integers");
    expect_refused("/accessors/1/count", 2, "has 2 texture coordinates for 3 positions");
    expect_refused("/meshes/0/primitives/0/attributes", Json::object(), "has no positions");
}

TEST_F(BadGltf, IndicesOfVertices) {
    GltfBuilder builder;
    builder.triangle();
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.accessor<std::uint32_t>({0, 1, 3}, "SCALAR", 5125);
    expect_message(builder, "names vertex 3, but there are 3");
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.accessor<std::uint32_t>({0, 1, 0xffffffffU}, "SCALAR", 5125);
    expect_message(builder, "names vertex 4294967295");
}

TEST_F(BadGltf, SparseAccessorsThatLie) {
    const auto with = [](const char* pointer, const Json& value) {
        GltfBuilder builder = good();
        const int indices = builder.view(GltfBuilder::raw<std::uint16_t>({1})), values = builder.view(GltfBuilder::raw<float>({5, 0, 0}));
        builder.json["accessors"][0]["sparse"] = {
            {"count", 1}, {"indices", {{"bufferView", indices}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
        if (*pointer) builder.json[Json::json_pointer(pointer)] = value;
        return builder;
    };
    EXPECT_EQ(load(with("", 0)).positions[1], glm::dvec3(5, 0, 0));
    expect_message(with("/accessors/0/sparse/count", 2), "needs 2 elements");
    expect_message(with("/accessors/0/sparse/count", -1), "negative size");
    expect_message(with("/accessors/0/sparse/indices/byteOffset", -8), "negative size");
    expect_message(with("/accessors/0/sparse/indices/componentType", 5126), "no unsigned integers");
    expect_message(with("/accessors/0/sparse/indices/bufferView", 42), "names buffer view 42");
    expect_message(with("/accessors/0/sparse/values/bufferView", -7), "names buffer view -7");
    GltfBuilder builder = with("", 0);
    const std::uint16_t place = 3;
    std::memcpy(&builder.bin[builder.json["bufferViews"][3]["byteOffset"].get<std::size_t>()], &place, sizeof place);
    expect_message(builder, "replaces element 3, but there are 3");
    builder = with("/accessors/0/count", std::uint64_t{1} << 40);
    builder.json["accessors"][0].erase("bufferView");
    expect_message(builder, "and no buffer");
}

TEST_F(BadGltf, NodesThatFormNoTree) {
    GltfBuilder builder = good();
    builder.json["nodes"][0]["children"] = {0};
    builder.json["scenes"] = {{{"nodes", {0}}}};
    expect_message(builder, "node 0 lies within itself");
    builder = good();
    for (int i = 1; i <= 40; ++i) builder.add("nodes", {{"children", {i - 1, i - 1}}});
    builder.json["nodes"][0].erase("mesh");
    builder.json["scenes"] = {{{"nodes", {40}}}};
    expect_message(builder, "nodes are shown more than 1000000 times");
    expect_refused("/nodes/0/children", Json::array({-5}), "names node -5");
    expect_refused("/nodes/0/matrix", Json::array({1, 2, 3}), "matrix has 3 numbers");
    expect_refused("/nodes/0/rotation", Json::array({0, 0, 0, 0}), "the rotation is zero");
    expect_refused("/nodes/0/translation", Json::array({1e300, 0, 0}), "further than 1e18");
    // Without a scene, a ring has no root and so is nowhere.
    builder = good();
    builder.json["nodes"][0]["children"] = {0};
    expect_message(builder, "no triangles");
}

/// Forbidden, and yet written: each place has the node.
TEST_F(BadGltf, NodesOfSeveralParentsAreShownAtEach) {
    GltfBuilder builder = good();
    builder.add("nodes", {{"children", {0}}});
    builder.add("nodes", {{"children", {0}}, {"translation", {5, 0, 0}}});
    builder.json["scenes"] = {{{"nodes", {1, 2}}}};
    const Scene scene = load(builder);
    EXPECT_EQ(scene.triangles.size(), 2 * load(good()).triangles.size());
    EXPECT_TRUE(has_warning(scene, "more than one parent"));
}

TEST_F(BadGltf, LongChainsOfNodesAreNoTrouble) {
    GltfBuilder builder = good();
    for (int i = 1; i <= 20000; ++i) builder.add("nodes", {{"children", {i - 1}}});
    builder.json["scenes"] = {{{"nodes", {20000}}}};
    EXPECT_EQ(load(builder).triangles.size(), 1U);
}

TEST_F(BadGltf, FilesElsewhere) {
    const std::string outside = folder_.parent_path().string();
    for (const char* uri : {"../secret.bin", "..%2fsecret.bin", "/etc/passwd", "file:///etc/passwd", "http://example.org/a.bin",
                            "a/../../b", "C:\\a.bin", "~/a.bin", "nothing.bin", ".", "data:text/html;base64,AAAA", ""}) {
        GltfBuilder builder = good();
        builder.bin.clear();
        builder.json["buffers"] = {{{"byteLength", 44}, {"uri", uri}}};
        EXPECT_NE(message_of(builder.gltf()), "") << uri;
        builder = good();
        builder.json["images"] = {{{"uri", uri}}};
        const std::string message = message_of(builder.gltf());  // an error, or a picture that is not there
        EXPECT_TRUE(!message.empty() || has_warning(load(builder), "is not there: materials go without it")) << uri;
    }
}

TEST_F(BadGltf, PicturesThatAreNotThere) {
    GltfBuilder builder;
    builder.add("images", {{"uri", "a%20b.png"}});
    builder.add("textures", {{"source", 0}});
    builder.material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}, {"baseColorFactor", {1, 0.5, 0, 1}}}},
                      {"emissiveTexture", {{"index", 0}}},
                      {"emissiveFactor", {1, 1, 1}}});
    const Scene scene = load(builder);
    EXPECT_TRUE(has_warning(scene, "picture \"a b.png\" is not there"));
    EXPECT_TRUE(has_warning(scene, "emits nothing, for want of its emissive texture"));
    EXPECT_EQ(scene.materials.at(0).albedo, glm::vec3(1, 0.5F, 0));
    EXPECT_FALSE(scene.shapes.at(0).emits);
    LoadOptions strict;
    strict.strict = true;
    EXPECT_THROW(load_scene(folder_ / "scene.gltf", strict), SceneError);
}

TEST_F(BadGltf, VerticesThatAreNowhere) {
    GltfBuilder builder;
    const float infinite = std::numeric_limits<float>::infinity();
    const Json primitive = {{"attributes", {{"POSITION", builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, infinite, 0, 0}, "VEC3")}}},
                            {"indices", builder.accessor(std::vector<std::uint16_t>{0, 1, 2, 0, 1, 3}, "SCALAR", 5123)}};
    builder.add("nodes", {{"mesh", builder.mesh(primitive)}});
    const Scene scene = load(builder);
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_TRUE(has_warning(scene, "1 vertices are nowhere (NaN or infinite); the 1 triangles that use them are left out"));
    builder = good();
    builder.json["accessors"][0]["min"] = {0, 0, 0};
    builder.json["accessors"][0]["max"] = {0.25, 0.25, 0};
    EXPECT_TRUE(has_warning(load(builder), "2 vertices lie far outside the bounds"));
}

TEST_F(BadGltf, TheFirstVersionIsNamed) {
    const std::string first = R"({"asset": {"version": "1.0"}, "meshes": {"m": {"primitives": []}}, "accessors": {"a": {}}})";
    EXPECT_NE(message_of(first).find("version \"1.0\" is not supported; 2.0 is: convert the file with \"gltf-pipeline"), std::string::npos);
    EXPECT_NE(message_of(R"({"meshes" : {"m": {}}})").find("version 1.0"), std::string::npos);
}

TEST_F(BadGltf, ImagesThatLie) {
    const auto with_image = [](const Json& image) {
        GltfBuilder builder;
        builder.add("images", image);
        builder.add("textures", {{"source", 0}});
        builder.material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        return builder;
    };
    expect_message(with_image({{"uri", "data:image/png;base64,AAAA"}}), "not a picture in a known format");
    expect_message(with_image({{"bufferView", 1}, {"mimeType", "image/png"}}), "not a picture in a known format");
    expect_message(with_image({{"bufferView", 55}, {"mimeType", "image/png"}}), "");
    GltfBuilder builder = with_image({{"bufferView", 0}, {"mimeType", "image/png"}});
    builder.json["bufferViews"][0]["byteLength"] = std::uint64_t{1} << 40;
    expect_message(builder, "beyond the end of its buffer");
    builder = with_image({{"bufferView", 0}, {"mimeType", "image/png"}});
    builder.json["textures"][0]["source"] = 6;
    expect_message(builder, "names image 6");
    builder.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["index"] = 9;
    expect_message(builder, "names texture 9");
}

TEST_F(BadGltf, RequiredExtensionsAreNamed) {
    for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu", "EXT_mesh_gpu_instancing"}) {
        GltfBuilder builder = good();
        builder.json["extensionsUsed"] = builder.json["extensionsRequired"] = {name};
        expect_message(builder, "the required extension \"" + std::string(name) + "\" is not supported");
        builder.json["accessors"][0]["bufferView"] = 99;  // as compressed files look to those who do not know the compression
        expect_message(builder, "the required extension \"" + std::string(name) + "\" is not supported");
        builder = good();
        builder.json["extensionsUsed"] = {name};
        EXPECT_TRUE(has_warning(load(builder), "extension \"" + std::string(name) + "\" is left out"));
    }
}

TEST_F(BadGltf, TextThatIsNoGltf) {
    for (const std::string& text :
         {std::string("{\"asset\""), std::string("{\"asset\":{\"version\":\"2.0\"}"), std::string("{\"asset\":[]}"),
          std::string("{\"asset\":{\"version\":\"1.0\"},\"meshes\":{}}"), std::string("{\"asset\":{\"version\":\"2.0\"},\"nodes\":[1]}"),
          std::string("{\"asset\":{\"version\":\"2.0\"},\"meshes\":[[]]}")})
        EXPECT_NE(message_of(text).find("scene.gltf: "), std::string::npos) << text;
    const std::string deep = "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(200000, '[') + std::string(200000, ']') + "}";
    EXPECT_NE(message_of(deep).find("nested more than"), std::string::npos);
    EXPECT_NE(message_of("{\"asset\":{\"version\":\"2.0\"},\"accessors\":[{\"count\":1e999}]}"), "");
}

TEST_F(BadGltf, ContainersThatLie) {
    const std::string bytes = good().glb();
    EXPECT_EQ(message_of(bytes, "a.glb"), "");
    for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_NE(message_of(bytes.substr(0, n), "a.glb"), "") << n;
    const auto with = [&](std::size_t at, std::size_t value) {
        std::string changed = bytes;
        changed.replace(at, 4, GltfBuilder::number(value));
        return message_of(changed, "a.glb");
    };
    const std::size_t json = good().glb().find("BIN") - 4;
    EXPECT_NE(with(4, 1).find("version 1"), std::string::npos);
    EXPECT_NE(with(8, 0xffffffff).find("truncated"), std::string::npos);
    EXPECT_NE(with(8, 0), "");
    EXPECT_NE(with(12, 0xffffffff).find("chunk 0 is longer than the file"), std::string::npos);
    EXPECT_NE(with(16, 0).find("chunk 0 is not of the expected type"), std::string::npos);
    EXPECT_NE(with(json, bytes.size() - json).find("chunk 1 is longer than the file"), std::string::npos);
    EXPECT_NE(with(json + 4, 7).find("chunk 1 is not of the expected type"), std::string::npos);
}

TEST_F(BadGltf, TextCutAnywhere) {
    const std::string text = good().gltf();
    for (std::size_t n = 40; n < text.size(); n += 7) EXPECT_NE(message_of(text.substr(0, n)), "") << n;
}

}  // namespace
}  // namespace pencil::test
