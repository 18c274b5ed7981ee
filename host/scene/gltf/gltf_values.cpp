#include "scene/gltf/gltf_values.h"

#include <cmath>

namespace pencil {
namespace {

const tinygltf::Value* member(const tinygltf::Value* object, const char* key) {
    return object && object->IsObject() && object->Has(key) ? &object->Get(key) : nullptr;
}

double number(const tinygltf::Value* value, double absent) {
    const double result = value && value->IsNumber() ? value->GetNumberAsDouble() : absent;
    return std::isfinite(result) ? result : absent;
}

}  // namespace

const tinygltf::Value* find_extension(const tinygltf::ExtensionMap& extensions, const char* name) {
    const auto place = extensions.find(name);
    return place == extensions.end() ? nullptr : &place->second;
}

double number_of(const tinygltf::Value* object, const char* key, double absent) { return number(member(object, key), absent); }

int index_of(const tinygltf::Value* object, const char* key, int absent) {
    const tinygltf::Value* value = member(object, key);
    return value && value->IsInt() ? value->GetNumberAsInt() : absent;
}

double element_of(const tinygltf::Value* object, const char* key, std::size_t i, double absent) {
    const tinygltf::Value* array = member(object, key);
    return array && array->IsArray() && i < array->ArrayLen() ? number(&array->Get(static_cast<int>(i)), absent) : absent;
}

glm::vec3 colour_of(const tinygltf::Value* object, const char* key, const glm::vec3& absent) {
    glm::vec3 colour(0.0F);
    for (std::size_t i = 0; i < 3; ++i)
        colour[static_cast<int>(i)] = static_cast<float>(element_of(object, key, i, absent[static_cast<int>(i)]));
    return colour;
}

tinygltf::TextureInfo texture_of(const tinygltf::Value* object, const char* key) {
    tinygltf::TextureInfo info;
    const tinygltf::Value* value = member(object, key);
    info.index = index_of(value, "index");
    info.texCoord = index_of(value, "texCoord", 0);
    const tinygltf::Value* extensions = member(value, "extensions");
    if (extensions && extensions->IsObject())
        for (const std::string& name : extensions->Keys()) info.extensions[name] = extensions->Get(name);
    return info;
}

}  // namespace pencil
