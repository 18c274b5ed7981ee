// `pencil info`: counts, sizes and what a render of this scene needs and leaves out. No device is opened.
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>

#include "app/commands.h"
#include "app/message.h"
#include "app/scene_listing.h"
#include "options/option_values.h"
#include "scene/formats/load_scene.h"
#include "util/format.h"

namespace pencil {
namespace {

void print_bounds(const Scene& scene) {
    if (scene.positions.empty()) {
        std::cout << "bounds     none: the scene has no geometry\n";
        return;
    }
    glm::dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Triangle3& triangle : scene.triangles) {
        for (int corner = 0; corner < 3; ++corner) {
            low = glm::min(low, scene.positions[triangle.corners[corner]]);
            high = glm::max(high, scene.positions[triangle.corners[corner]]);
        }
    }
    std::cout << "bounds     " << vector_text(low) << " to " << vector_text(high) << ", diagonal " << format_short(glm::length(high - low))
              << "\n";
}

void print_shapes(const Scene& scene) {
    std::cout << "triangles  " << scene.triangles.size() << "\nshapes     " << scene.shapes.size() << "\n";
    for (const Shape& shape : scene.shapes) {
        std::cout << "  " << printable(shape.id) << ": " << printable(shape.kind) << ", " << shape.triangle_count << " triangles";
        if (shape.triangle_count > 0) {
            const std::string& material = scene.materials[scene.triangles[shape.first_triangle].material].id;
            if (!material.empty()) std::cout << ", " << printable(material);
        }
        if (shape.emits) std::cout << ", emits " << vector_text(shape.radiance);
        std::cout << "\n";
    }
}

void print_film(const Scene& scene) {
    const char* const filters[] = {"box", "tent", "gaussian", "mitchell", "catmullrom", "lanczos"};
    const PerspectiveSensor& sensor = scene.sensor;
    std::cout << "film       " << sensor.width << "x" << sensor.height;
    if (sensor.crop_width > 0)
        std::cout << ", of it " << sensor.crop_width << "x" << sensor.crop_height << " from (" << sensor.crop_x << ", " << sensor.crop_y
                  << ")";
    std::cout << ", " << filters[static_cast<int>(sensor.filter.kind)] << " filter of radius " << format_short(sensor.filter.radius);
    if (sensor.orthographic)
        std::cout << ", orthographic";
    else
        std::cout << ", horizontal field of view " << format_short(sensor.fov_x) << " degrees";
    if (sensor.aperture_radius > 0)
        std::cout << ", lens of radius " << format_short(sensor.aperture_radius) << " sharp at " << format_short(sensor.focus_distance);
    std::cout << "\nmax_depth  " << (scene.max_depth < 0 ? "no limit" : std::to_string(scene.max_depth)) << "\n";
}

/// One line per feature that a scene can ask for: needed, or what its absence saves.
void print_needs(const Scene& scene) {
    const auto line = [](bool needed, const std::string& feature, const std::string& saving) {
        std::cout << "  " << (needed ? "needed    " : "left out  ") << feature << (needed ? "" : ": " + saving) << "\n";
    };
    const bool lights = !scene.point_lights.empty(), far = !scene.directional_lights.empty() || scene.environment;
    const bool area = std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) { return shape.emits; });
    const bool smooth = std::any_of(
        scene.triangles.begin(), scene.triangles.end(),
        [&](const Triangle3& triangle) {
            const glm::vec3 normal = triangle.corners[0] < scene.normals.size() ? scene.normals[triangle.corners[0]] : glm::vec3(0.0F);
            return normal != glm::vec3(0.0F);
        });
    const bool reflects = std::any_of(scene.materials.begin(), scene.materials.end(),
                                      [](const SceneMaterial& m) { return m.model != MATERIAL_DIFFUSE || m.albedo != glm::vec3(0.0F); });
    const bool indirect = reflects && (lights || area || far) && !scene.triangles.empty() && (scene.max_depth < 0 || scene.max_depth > 2);
    std::cout << "features\n";
    line(area, "area emitters", "no emitted radiance in maps or film");
    line(lights, "point lights", "no light samples of points");
    line(smooth, "shading normals", "every triangle is flat; its plane's normal is used");
    line(indirect, "indirect light", "nothing reflects light twice; no pencil transport");
}

}  // namespace

ExitCode run_info(const InfoCommand& command) {
    const Scene scene = load_scene(command.scene, command.load);
    for (const std::string& warning : scene.warnings) print_warning(warning);
    std::cout << "scene      " << printable(command.scene.string()) << "\n";
    print_shapes(scene);
    list_lights(scene);
    list_materials(scene);
    list_textures(scene);
    print_film(scene);
    print_bounds(scene);
    print_needs(scene);
    return ExitCode::ok;
}

}  // namespace pencil
