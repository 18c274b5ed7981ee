// Kd and Ks are values of a screen there, materials have one side, and of the models of illumination 2 is Phong's, 4, 6, 7 and 9 are glass,
// 5 and 8 aluminium, and all others diffuse.
#include "scene/mitsuba/mtl_bsdfs.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "scene/meshes/read_mtl.h"
#include "scene/scene_file.h"
#include "scene/text.h"
#include "util/error.h"

namespace pencil {
namespace {

constexpr double largest_exponent = 1e6;  // beyond it a lobe is a mirror

pugi::xml_node add(pugi::xml_node parent, const char* element, const char* name, const std::string& value) {
    pugi::xml_node node = parent.append_child(element);
    node.append_attribute("name") = name;
    node.append_attribute("value") = value.c_str();
    return node;
}

pugi::xml_node add_object(pugi::xml_node parent, const char* element, const char* type) {
    pugi::xml_node node = parent.append_child(element);
    node.append_attribute("type") = type;
    return node;
}

pugi::xml_node add_bitmap(pugi::xml_node parent, const MtlMap& map) {
    pugi::xml_node node = add_object(parent, "texture", "bitmap");
    add(node, "string", "filename", map.file);
    return node;
}

/// A picture, or else the colour, black if there is none.
void add_colour(pugi::xml_node parent, const char* name, const MtlMap& map, const std::optional<glm::dvec3>& colour) {
    if (!map.file.empty()) {
        add_bitmap(parent, map).append_attribute("name") = name;
        return;
    }
    const glm::dvec3 c = glm::min(colour.value_or(glm::dvec3(0.0)), glm::dvec3(1.0));
    add(parent, "srgb", name, fmt::format("{}, {}, {}", c.x, c.y, c.z));
}

int model_of(const MtlMaterial& m) {
    const int model = m.model.value_or(0);
    const glm::dvec3 specular = m.specular.value_or(glm::dvec3(0.0));
    const bool shines = (!m.specular_map.file.empty() || specular != glm::dvec3(0.0)) && m.exponent.value_or(0.0) > 0;
    return model == 2 && !shines ? 1 : model;
}

void add_scattering(pugi::xml_node bsdf, const MtlMaterial& m) {
    const int model = model_of(m);
    pugi::xml_attribute type = bsdf.append_attribute("type");
    if (model == 2) {
        type = "phong";
        add_colour(bsdf, "diffuse_reflectance", m.diffuse_map, m.diffuse);
        add_colour(bsdf, "specular_reflectance", m.specular_map, m.specular);
        add(bsdf, "float", "exponent", fmt::format("{}", std::min(*m.exponent, largest_exponent)));
    } else if (model == 4 || model == 6 || model == 7 || model == 9) {
        type = "dielectric";
    } else if (model == 5 || model == 8) {
        type = "conductor";
        add(bsdf, "string", "material", "Al");
    } else {
        type = "diffuse";
        add_colour(bsdf, "reflectance", m.diffuse_map, m.diffuse);
    }
}

/// Covered by its opacity, with its relief, if it has such.
pugi::xml_node add_bsdf(pugi::xml_node parent, const MtlMaterial& m) {
    pugi::xml_node bsdf = parent.append_child("bsdf"), outermost = bsdf;
    bsdf.append_attribute("id") = m.name.c_str();
    if (!m.opacity_map.file.empty() || m.opacity.value_or(1.0) != 1.0) {
        bsdf.append_attribute("type") = "mask";
        if (!m.opacity_map.file.empty())
            add_bitmap(bsdf, m.opacity_map).append_attribute("name") = "opacity";
        else
            add(bsdf, "float", "opacity", fmt::format("{}", std::clamp(*m.opacity, 0.0, 1.0)));
        bsdf = bsdf.append_child("bsdf");
    }
    if (!m.bump_map.file.empty()) {
        bsdf.append_attribute("type") = "bumpmap";
        add(add_bitmap(bsdf, m.bump_map), "boolean", "raw", "true");
        bsdf = bsdf.append_child("bsdf");
    }
    add_scattering(bsdf, m);
    return outermost;
}

}  // namespace

std::map<std::string, pugi::xml_node> MtlBsdfs::of(const Mesh& mesh, const std::filesystem::path& folder, pugi::xml_node shape) {
    Library result;
    for (const std::string& name : mesh.libraries) {
        try {
            const Library& found = library(name, folder, shape);
            result.insert(found.begin(), found.end());
        } catch (const SceneError& error) {
            source_.approximate(shape, without_place(error, source_.where(shape)) + "; its materials are left out");
        }
    }
    return result;
}

const MtlBsdfs::Library& MtlBsdfs::library(const std::string& name, const std::filesystem::path& folder, pugi::xml_node shape) {
    const std::filesystem::path file = source_.find_file(name, folder, shape);
    const auto place = libraries_.find(file);
    return place != libraries_.end() ? place->second : libraries_[file] = read(file, shape);
}

MtlBsdfs::Library MtlBsdfs::read(const std::filesystem::path& file, pugi::xml_node shape) {
    std::vector<SceneError> defects;
    const std::string text = read_regular_file(file, max_mtl_bytes, source_.where(shape));
    const std::vector<MtlMaterial> materials = read_mtl(text, shown(file), defects);
    for (const SceneError& defect : defects) source_.approximate(shape, std::string(defect.what()) + "; the line is left out");
    pugi::xml_node top = source_.add_document(file, shape);
    Library result;
    for (const MtlMaterial& material : materials)
        if (result.count(material.name) == 0) result[material.name] = add_bsdf(top, material);
    return result;
}

}  // namespace pencil
