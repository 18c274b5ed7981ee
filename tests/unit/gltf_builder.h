// Small glTF files made by tests: a JSON document, and one buffer that grows.
#pragma once

#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace pencil::test {

class GltfBuilder {
public:
    using Json = nlohmann::ordered_json;

    GltfBuilder() { json["asset"]["version"] = "2.0"; }

    int view(const std::string& bytes) {
        const std::size_t offset = bin.size();
        bin += bytes;
        bin.resize((bin.size() + 3) / 4 * 4, '\0');
        return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
    }
    template <class T>
    static std::string raw(const std::vector<T>& values) {
        std::string bytes(values.size() * sizeof(T), '\0');
        if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
        return bytes;
    }
    template <class T>
    int accessor(const std::vector<T>& values, const std::string& type, int component_type, bool normalized = false) {
        const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type.back() - '0');
        Json accessor = {
            {"bufferView", view(raw(values))}, {"componentType", component_type}, {"count", values.size() / components}, {"type", type}};
        if (normalized) accessor["normalized"] = true;
        return add("accessors", accessor);
    }
    int floats(const std::vector<float>& values, const std::string& type) { return accessor(values, type, 5126); }

    /// Index of the element in the list of this name.
    int add(const char* list, const Json& element) {
        json[list].push_back(element);
        return static_cast<int>(json[list].size()) - 1;
    }
    int mesh(const Json& primitive) { return add("meshes", {{"primitives", Json::array({primitive})}}); }
    /// One triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), with texture coordinates (0, 0), (1, 0), (0, 1), at a node.
    int triangle(const Json& extra = Json::object()) {
        Json primitive = {
            {"attributes",
             {{"POSITION", floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3")}, {"TEXCOORD_0", floats({0, 0, 1, 0, 0, 1}, "VEC2")}}}};
        primitive.update(extra);
        return add("nodes", {{"mesh", mesh(primitive)}});
    }
    /// The triangle with this material.
    int material(const Json& content) {
        const int index = add("materials", content);
        triangle({{"material", index}});
        return index;
    }
    int light(const Json& content) {
        Json& lights = json["extensions"]["KHR_lights_punctual"]["lights"];
        lights.push_back(content);
        return static_cast<int>(lights.size()) - 1;
    }

    /// With the buffer inside.
    std::string gltf() const {
        Json whole = json;
        if (!bin.empty()) whole["buffers"] = {{{"byteLength", bin.size()}, {"uri", "data:application/octet-stream;base64," + base64(bin)}}};
        return whole.dump();
    }
    std::string glb() const {
        Json whole = json;
        if (!bin.empty()) whole["buffers"] = {{{"byteLength", bin.size()}}};
        std::string text = whole.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string chunks = number(text.size()) + "JSON" + text;
        if (!bin.empty()) chunks += number(bin.size()) + std::string("BIN\0", 4) + bin;
        return "glTF" + number(2) + number(chunks.size() + 12) + chunks;
    }

    static std::string number(std::size_t value) { return raw(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)}); }

    static std::string base64(const std::string& bytes) {
        const char* const digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string result;
        for (std::size_t i = 0; i < bytes.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
            for (std::size_t k = 0; k < 4; ++k) result += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
        }
        return result;
    }

    Json json;
    std::string bin;
};

}  // namespace pencil::test
