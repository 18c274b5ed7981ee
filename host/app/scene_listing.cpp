#include "app/scene_listing.h"

#include <algorithm>
#include <iostream>

#include "app/message.h"
#include "util/format.h"

namespace pencil {
namespace {

std::string named(const std::string& id) { return id.empty() ? "(unnamed)" : printable(id); }

std::string texture_text(int texture) { return texture == no_texture ? "" : " x texture " + std::to_string(texture); }

std::string roughness(const SceneMaterial& m) {
    if (m.alpha == glm::vec2(0.0F)) return ", smooth";
    const std::string v = m.alpha.x == m.alpha.y ? "" : " x " + format_short(m.alpha.y);
    return std::string(m.beckmann ? ", beckmann" : ", ggx") + " roughness " + format_short(m.alpha.x) + v + texture_text(m.alpha_texture);
}

std::string eta(const SceneMaterial& m) {
    return ", index " + (m.eta.x == m.eta.y && m.eta.y == m.eta.z ? format_short(m.eta.x) : vector_text(m.eta));
}

std::string albedo(const SceneMaterial& m) { return ", albedo " + vector_text(m.albedo) + texture_text(m.albedo_texture); }

std::string blend(const SceneMaterial& m) {
    return "blend of " + std::to_string(m.blended[0]) + " and " + std::to_string(m.blended[1]) + ", weight " + format_short(m.weight) +
           texture_text(m.weight_texture) + (m.weight_is_opacity ? " (opacity)" : "");
}

std::string model_text(const SceneMaterial& m) {
    switch (m.model) {
        case MATERIAL_DIFFUSE:
            return "diffuse" + albedo(m);
        case MATERIAL_ROUGH_DIFFUSE:
            return "rough diffuse" + albedo(m) + ", deviation " + format_short(m.alpha.x);
        case MATERIAL_CONDUCTOR:
            return "conductor" + (m.perfect_mirror ? std::string(", reflects everything") : eta(m) + ", k " + vector_text(m.k)) +
                   roughness(m);
        case MATERIAL_PLASTIC:
            return "plastic" + albedo(m) + eta(m) + roughness(m) + (m.nonlinear ? ", nonlinear" : "");
        case MATERIAL_DIELECTRIC:
            return std::string(m.thin ? "thin dielectric" : "dielectric") + eta(m) + roughness(m);
        case MATERIAL_PHONG:
            return "phong" + albedo(m) + ", specular " + vector_text(m.specular) + ", exponent " + format_short(m.exponent);
        case MATERIAL_PRINCIPLED:
            return "principled" + albedo(m) + ", roughness " + format_short(m.alpha.x) + texture_text(m.alpha_texture) + ", metallic " +
                   format_short(m.principled.metallic) + texture_text(m.principled.metallic_texture) + eta(m);
        case MATERIAL_BLEND:
            return blend(m);
        case MATERIAL_PASS:
            return "lets light through";
        default:
            return "model " + std::to_string(m.model) + albedo(m);
    }
}

std::string relief(const SceneMaterial& m) {
    if (m.normal_texture == no_texture) return "";
    return std::string(m.bump ? ", bumps" : ", normals") + " of texture " + std::to_string(m.normal_texture);
}

void list_point_light(const PointLight& light) {
    const char* kind = light.profile >= 0 ? "profile" : light.is_spot ? "spot" : "point";
    std::cout << "  " << kind << " at " << vector_text(light.position) << ", intensity " << vector_text(light.intensity);
    if (light.is_spot) std::cout << ", cone of " << format_short(light.cutoff) << " degrees";
    std::cout << "\n";
}

}  // namespace

std::string vector_text(const glm::dvec3& v) { return "(" + format_short(v.x) + ", " + format_short(v.y) + ", " + format_short(v.z) + ")"; }

void list_lights(const Scene& scene) {
    const auto area =
        static_cast<std::size_t>(std::count_if(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) { return shape.emits; }));
    const std::size_t points = scene.point_lights.size(), parallel = scene.directional_lights.size();
    const std::size_t around = scene.environment ? 1 : 0;
    std::cout << "emitters   " << area + points + parallel + around << ": " << area << " area, " << points << " point";
    if (parallel > 0) std::cout << ", " << parallel << " directional";
    if (around > 0) std::cout << ", " << around << " environment";
    std::cout << "\n";
    for (const PointLight& light : scene.point_lights) list_point_light(light);
    for (const DirectionalLight& light : scene.directional_lights)
        std::cout << "  directional along " << vector_text(light.direction) << ", irradiance " << vector_text(light.irradiance) << "\n";
    if (!scene.environment) return;
    std::cout << "  environment of radiance " << vector_text(scene.environment->radiance);
    if (scene.environment->is_map()) std::cout << " x map of " << scene.environment->width << "x" << scene.environment->height;
    std::cout << "\n";
}

void list_materials(const Scene& scene) {
    std::cout << "materials  " << scene.materials.size() << "\n";
    for (const SceneMaterial& m : scene.materials) {
        std::cout << "  " << named(m.id) << ": " << model_text(m) << relief(m) << (m.two_sided ? ", two-sided" : "");
        if (m.back >= 0) std::cout << ", back " << m.back;
        std::cout << "\n";
    }
}

void list_textures(const Scene& scene) {
    if (scene.textures.empty()) return;
    std::cout << "textures   " << scene.textures.size() << "\n";
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const Texture& texture = scene.textures[i];
        std::cout << "  " << i << ": " << named(texture.name);
        if (texture.kind == Texture::Kind::bitmap) std::cout << ", " << texture.width << "x" << texture.height;
        std::cout << "\n";
    }
}

}  // namespace pencil
