// Rows 20 to 29: glTF and its containers.
#include <limits>

#include "hostile/hostile_case.h"
#include "unit/gltf_builder.h"

namespace pencil_test {
namespace {

using pencil::test::GltfBuilder;
using Json = GltfBuilder::Json;

GltfBuilder good() {
    GltfBuilder builder;
    builder.triangle();
    builder.json["meshes"][0]["primitives"][0]["indices"] = builder.accessor<std::uint16_t>({0, 1, 2}, "SCALAR", 5123);
    return builder;
}

HostileCase gltf(const std::string& name, int code, const std::string& says, const std::function<GltfBuilder()>& make) {
    return reads(
        name, code, says, "a.gltf", [=] { return make().gltf(); });
}

/// The good file with the value at a JSON pointer replaced.
HostileCase with(const std::string& name, int code, const std::string& says, const char* pointer, const Json& value) {
    return gltf(
        name, code, says,
        [=] {
            GltfBuilder builder = good();
            builder.json[Json::json_pointer(pointer)] = value;
            return builder;
        });
}

/// The good file with a buffer elsewhere.
HostileCase buffer_at(const std::string& name, const std::string& says, const std::string& uri, const Json& length = 44) {
    return reads(
        name, 3, says, "a.gltf",
        [=] {
            Json json = good().json;
            json["buffers"] = {{{"byteLength", length}, {"uri", uri}}};
            return json.dump();
        });
}

std::vector<HostileCase> buffers() {
    const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    return {
        with("20-good", 0, "triangles  1", "/asset/generator", "a test"),
        buffer_at("20-buffer-outside", "outside", "../../../../../../etc/passwd"),
        buffer_at("20-buffer-absolute", "outside", "/etc/passwd"),
        buffer_at("20-buffer-http", "", "http://example.com/a.bin"),
        buffer_at("20-buffer-percent", "outside", "%2e%2e/%2e%2e/%2e%2e/%2e%2e/etc/passwd"),
        buffer_at("20-buffer-file", "", "file:///etc/passwd"),
        with("21-count-2^62", 3, "needs 4611686018427387904 elements", "/accessors/0/count", std::uint64_t{1} << 62),
        with("21-count-2^64", 3, "elements", "/accessors/0/count", most),
        with("21-count--1", 3, "", "/accessors/0/count", -1),
        with("21-stride-4", 3, "apart", "/bufferViews/0/byteStride", 4),
        with("21-stride-2^31", 3, "", "/bufferViews/0/byteStride", std::uint64_t{1} << 31),
        with("21-offset-wraps", 3, "beyond the end", "/bufferViews/0/byteOffset", most - 3),
        with("22-strip", 0, "", "/meshes/0/primitives/0/mode", 5),
        with("22-points", 3, "", "/meshes/0/primitives/0/mode", 0),
        with("22-mode-9", 3, "", "/meshes/0/primitives/0/mode", 9),
        with("22-no-accessor", 3, "out of bounds", "/meshes/0/primitives/0/indices", 99),
        gltf("22-index-beyond", 3, "names vertex 3",
             [] {
                 GltfBuilder builder = good();
                 builder.json["meshes"][0]["primitives"][0]["indices"] = builder.accessor<std::uint32_t>({0, 1, 3}, "SCALAR", 5125);
                 return builder;
             }),
        gltf("23-sparse-beyond", 3, "",
             [] {
                 GltfBuilder builder = good();
                 const int indices = builder.view(GltfBuilder::raw<std::uint16_t>({9})),
                           values = builder.view(GltfBuilder::raw<float>({5, 0, 0}));
                 builder.json["accessors"][0]["sparse"] = {
                     {"count", 1}, {"indices", {{"bufferView", indices}, {"componentType", 5123}}}, {"values", {{"bufferView", values}}}};
                 return builder;
             }),
        gltf("23-sparse-of-2^40", 3, "",
             [] {
                 GltfBuilder builder = good();
                 builder.json["accessors"][0].erase("bufferView");
                 builder.json["accessors"][0]["count"] = std::uint64_t{1} << 40;
                 return builder;
             }),
    };
}

std::vector<HostileCase> nodes() {
    return {
        gltf(
            "24-node-in-itself", 3, "lies within itself",
            [] {
                GltfBuilder builder = good();
                builder.json["nodes"][0]["children"] = {0};
                builder.json["scenes"] = {{{"nodes", {0}}}};
                return builder;
            }),
        gltf(
            "24-chain-of-1e5", 0, "",
            [] {
                GltfBuilder builder = good();
                for (int i = 1; i <= 100000; ++i) builder.add("nodes", {{"children", {i - 1}}});
                builder.json["scenes"] = {{{"nodes", {100000}}}};
                return builder;
            }),
        gltf(
            "24-doubled-40-times", 3, "more than 1000000 times",
            [] {
                GltfBuilder builder = good();
                for (int i = 1; i <= 40; ++i) builder.add("nodes", {{"children", {i - 1, i - 1}}});
                builder.json["scenes"] = {{{"nodes", {40}}}};
                return builder;
            }),
        gltf(
            "24-two-parents", 0, "more than one parent",
            [] {
                GltfBuilder builder = good();
                for (int i = 0; i < 2; ++i) builder.add("nodes", {{"children", {0}}});
                builder.json["scenes"] = {{{"nodes", {1, 2}}}};
                return builder;
            }),
        with("24-no-mesh", 3, "names mesh 7", "/nodes/0/mesh", 7),
        with("24-no-scene", 3, "names scene 4", "/scene", 4),
        reads(
            "25-json-200000-deep", 3, "nested more than", "a.gltf",
            [] { return "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + std::string(200000, '[') + std::string(200000, ']') + "}"; }),
        reads(
            "25-json-of-3e6-objects", 3, "more than 2000000 objects", "a.gltf",
            [] {
                std::string text = good().gltf();
                return text.substr(0, text.size() - 1) + ",\"extras\":[" + repeated("{\"a\":1},", 3000000) + "0]}";
            }),
    };
}

std::vector<HostileCase> containers() {
    const auto glb = [](const std::string& name, const std::string& says, const std::function<void(std::string&)>& change) {
        return reads(
            name, 3, says, "a.glb",
            [=] {
                std::string bytes = good().glb();
                change(bytes);
                return bytes;
            });
    };
    const auto number = [](std::string& bytes, std::size_t at, std::size_t value) { bytes.replace(at, 4, GltfBuilder::number(value)); };
    return {
        glb("26-magic", "", [](std::string& bytes) { bytes[0] = 'x'; }),
        glb("26-version-1", "version 1", [=](std::string& bytes) { number(bytes, 4, 1); }),
        glb("26-length-lies", "truncated", [=](std::string& bytes) { number(bytes, 8, 0xfffffff0); }),
        glb("26-chunk-beyond", "longer than the file", [=](std::string& bytes) { number(bytes, 12, 0xfffffff0); }),
        glb("26-no-bin", "",
            [=](std::string& bytes) {
                bytes.resize(bytes.find("BIN") - 4);
                number(bytes, 8, bytes.size());
            }),
        buffer_at("27-bad-base64", "", "data:application/octet-stream;base64,%%%%"),
        buffer_at("27-short-data", "", "data:application/octet-stream;base64,AAAA"),
        buffer_at("27-length-1e300", "", "data:application/octet-stream;base64,AAAA", 1e300),
        buffer_at("27-length--5", "", "data:application/octet-stream;base64,AAAA", -5),
        reads("27-data-of-100-mib", 3, "", "a.gltf",
              [] {
                  Json json = good().json;
                  json["buffers"] = {{{"byteLength", 44}, {"uri", "data:application/octet-stream;base64," + std::string(100 << 20, 'A')}}};
                  return json.dump();
              }),
        with("28-draco", 3, "KHR_draco_mesh_compression", "/extensionsRequired", Json::array({"KHR_draco_mesh_compression"})),
        with("28-unknown", 3, "EXT_new", "/extensionsRequired", Json::array({"EXT_new"})),
    };
}

std::vector<HostileCase> lights() {
    const auto light = [](const std::string& name, int code, const Json& content) {
        return gltf(name, code, "", [=] {
            GltfBuilder builder = good();
            builder.add("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", builder.light(content)}}}}}});
            return builder;
        });
    };
    return {
        light("29-intensity--1", 3, {{"type", "point"}, {"intensity", -1}}),
        light("29-cone-inside-out", 3, {{"type", "spot"}, {"spot", {{"innerConeAngle", 1.0}, {"outerConeAngle", 0.5}}}}),
        light("29-range-0", 0, {{"type", "point"}, {"range", 0}}),
        gltf("29-emission-1e30", 0, "",
             [] {
                 GltfBuilder builder;
                 builder.material(
                     {{"emissiveFactor", {1, 1, 1}}, {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 1e30}}}}}});
                 return builder;
             }),
    };
}

}  // namespace

std::vector<HostileCase> hostile_gltf() {
    std::vector<HostileCase> cases;
    for (const auto& more : {buffers(), nodes(), containers(), lights()}) cases.insert(cases.end(), more.begin(), more.end());
    return cases;
}

}  // namespace pencil_test
