// Values out of a glTF extension, whose content tinygltf gives as it stands in the file: any type may stand anywhere.
#pragma once

#include <glm/vec3.hpp>
#include <string>

#include "scene/gltf/gltf_file.h"

namespace pencil {

/// The extension's object, or null.
const tinygltf::Value* find_extension(const tinygltf::ExtensionMap& extensions, const char* name);

/// Members of `object`, or what is used where they are absent or of another type. A null object has no members.
double number_of(const tinygltf::Value* object, const char* key, double absent);
int index_of(const tinygltf::Value* object, const char* key, int absent = -1);
glm::vec3 colour_of(const tinygltf::Value* object, const char* key, const glm::vec3& absent);
/// Element `i` of an array.
double element_of(const tinygltf::Value* object, const char* key, std::size_t i, double absent);
/// A texture with its set of coordinates and its own extensions; index -1 if absent.
tinygltf::TextureInfo texture_of(const tinygltf::Value* object, const char* key);

}  // namespace pencil
