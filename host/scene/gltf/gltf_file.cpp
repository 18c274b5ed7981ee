// The parser is tinygltf, which opens any file that it is told to: it gets its files from here instead. Images are not decoded by it.
#include "scene/gltf/gltf_file.h"

#include <algorithm>
#include <optional>

#include "scene/gltf/embedded_files.h"
#include "scene/gltf/gltf_container.h"
#include "scene/gltf/gltf_values.h"
#include "scene/scene_file.h"
#include "scene/text.h"

namespace pencil {
namespace {

constexpr std::string_view supported_extensions =
    "KHR_lights_punctual KHR_materials_clearcoat KHR_materials_emissive_strength KHR_materials_ior KHR_materials_pbrSpecularGlossiness "
    "KHR_materials_sheen KHR_materials_specular KHR_materials_transmission KHR_materials_unlit KHR_materials_volume KHR_mesh_quantization "
    "KHR_texture_transform";

bool is_known(const std::string& extension) {
    const std::vector<std::string_view> known = tokens(supported_extensions);
    return std::find(known.begin(), known.end(), extension) != known.end();
}

/// How a scene can be had without the extension.
std::string advice_on(const std::string& extension) {
    const auto contains = [&](const char* part) { return extension.find(part) != std::string::npos; };
    if (contains("draco") || contains("meshopt")) return "; export it without compression of meshes, or decompress it with gltf-transform";
    if (contains("basisu") || contains("webp") || contains("dds") || contains("avif")) return "; export it with textures in PNG or JPEG";
    return "";
}

/// Hands out the files that a scene names, from the folders alone that it may read.
struct Files {
    const FileSearch& search;
    std::filesystem::path folder;
    std::string where;
    EmbeddedFiles embedded;
    std::vector<std::string> missing;
};

std::optional<std::filesystem::path> find_file(const std::string& name, void* files) {
    const Files& of = *static_cast<const Files*>(files);
    if (name.substr(0, 5) == "data:") throw SceneError(of.where, "data URI " + in_quotes(name.substr(0, 40)) + " is not of a known type");
    return of.search.find_if_there(name, of.folder, of.where);
}

/// tinygltf asks a second time, for the same below ".".
bool file_exists(const std::string& name, void* files) {
    if (static_cast<const Files*>(files)->embedded.has(name) || find_file(name, files)) return true;
    std::vector<std::string>& missing = static_cast<Files*>(files)->missing;
    if (name.substr(0, 2) != "./" && std::find(missing.begin(), missing.end(), name) == missing.end()) missing.push_back(name);
    return false;
}

std::string same_path(const std::string& name, void*) { return name; }

bool read_file(std::vector<unsigned char>* out, std::string*, const std::string& name, void* files) {
    const Files& of = *static_cast<const Files*>(files);
    if (of.embedded.has(name)) {
        if (!of.embedded.decode(name, *out)) throw SceneError(of.where, "a data URI is not in base 64");
        return true;
    }
    const std::optional<std::filesystem::path> file = find_file(name, files);
    if (!file) return false;
    const std::string bytes = read_regular_file(*file, max_mesh_bytes, of.where);
    out->assign(bytes.begin(), bytes.end());
    return true;
}

bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }

/// Keeps the encoded bytes. Those in a buffer stay there: the range that tinygltf hands over has not been checked.
bool keep_image(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    image->as_is = true;
    return true;
}

}  // namespace

GltfFile::GltfFile(const std::filesystem::path& file, const LoadOptions& options)
    : path_(file), problems_(options.strict), search_(file.parent_path(), options.allowed, problems_) {
    const std::string bytes = read_regular_file(file, max_mesh_bytes, shown(file));
    try {
        parse(bytes);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        fail("this is not well-formed glTF: " + escaped(error.what(), 200));
    }
    check_extensions();
    take_specular_glossiness();
}

void GltfFile::parse(const std::string& bytes) {
    const std::string_view json = checked_gltf_json(bytes, shown(path_));
    const bool is_text = !is_glb(bytes);
    Files files{search_, path_.parent_path(), shown(path_), EmbeddedFiles(is_text ? json : std::string_view()), {}};
    tinygltf::TinyGLTF parser;
    parser.SetFsCallbacks({file_exists, same_path, read_file, write_nothing, &files});
    parser.SetImageLoader(keep_image, nullptr);
    std::string error, warning;
    const std::string& text = files.embedded.json();
    const bool read = is_text ? parser.LoadASCIIFromString(&model_, &error, &warning, text.data(), static_cast<unsigned>(text.size()), "")
                              : parser.LoadBinaryFromMemory(&model_, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
                                                            static_cast<unsigned>(bytes.size()), "");
    if (!read) {
        check_required_extensions();  // they explain much of what looks wrong
        if (is_gltf_1(json)) fail("glTF version 1.0 is not supported" + advice_on_version);
        if (error.find("File not found") != std::string::npos && !files.missing.empty())  // a buffer: says why
            read_regular_file(search_.find(files.missing.back(), files.folder, files.where), max_mesh_bytes, files.where);
        fail("this is not well-formed glTF: " + escaped(trimmed(error), 200));
    }
    for (tinygltf::Image& image : model_.images)
        if (files.embedded.has(image.uri)) image.uri.clear();
    if (!files.missing.empty()) warning.clear();  // says the same, in other words
    for (const std::string& name : files.missing)
        approximate("picture " + in_quotes(name) +
                    " is not there: materials go without it; put it beside the file, or give --allow FOLDER");
    for (const std::string& message : {error, warning})
        if (!trimmed(message).empty()) warn(escaped(trimmed(message), 200));
    if (model_.asset.version.substr(0, 2) != "2.")
        fail("glTF version " + in_quotes(model_.asset.version) + " is not supported" + advice_on_version);
}

/// The diffuse colour stands where the base colour does; the rest is left to those who read materials.
void GltfFile::take_specular_glossiness() {
    for (tinygltf::Material& material : model_.materials) {
        const tinygltf::Value* glossy = find_extension(material.extensions, "KHR_materials_pbrSpecularGlossiness");
        if (!glossy) continue;
        tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
        pbr.metallicRoughnessTexture = {};
        pbr.metallicFactor = 0;
        const glm::vec3 colour = colour_of(glossy, "diffuseFactor", glm::vec3(1.0F));
        pbr.baseColorFactor = {colour.x, colour.y, colour.z, element_of(glossy, "diffuseFactor", 3, 1.0)};
        pbr.baseColorTexture = texture_of(glossy, "diffuseTexture");
    }
}

void GltfFile::check_required_extensions() const {
    for (const std::string& name : model_.extensionsRequired)
        if (!is_known(name)) fail("the required extension " + in_quotes(name) + " is not supported" + advice_on(name));
}

void GltfFile::check_extensions() {
    check_required_extensions();
    for (const std::string& name : model_.extensionsUsed)
        if (!is_known(name)) approximate("extension " + in_quotes(name) + " is left out");
}

void GltfFile::fail(const std::string& message) const { throw SceneError(shown(path_), message); }

void GltfFile::warn(const std::string& message) { problems_.warn(shown(path_), message); }

void GltfFile::approximate(const std::string& message) { problems_.approximate(shown(path_), message); }

std::vector<std::string> GltfFile::warnings() const {
    problems_.throw_errors();
    return problems_.warnings();
}

std::string named(const char* kind, std::size_t index, const std::string& name) {
    const std::string label = std::string(kind) + " " + std::to_string(index);
    return name.empty() ? label : label + " " + in_quotes(name);
}

}  // namespace pencil
