// `pencil info`: counts, sizes and what a render of this scene needs and leaves out. No device is opened.
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>

#include "app/commands.h"
#include "app/message.h"
#include "util/format.h"
#include "options/option_values.h"
#include "scene/mitsuba/load_scene.h"

namespace pencil {
namespace {

std::string vector_text(const glm::dvec3& v) { return "(" + format_short(v.x) + ", " + format_short(v.y) + ", " + format_short(v.z) + ")"; }

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
        if (shape.bsdf < scene.bsdfs.size() && !scene.bsdfs[shape.bsdf].id.empty()) {
            std::cout << ", " << printable(scene.bsdfs[shape.bsdf].id);
        }
        if (shape.emits) {
            std::cout << ", emits " << vector_text(shape.radiance);
        }
        std::cout << "\n";
    }
}

void print_lights(const Scene& scene) {
    const auto area_lights = std::count_if(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) { return shape.emits; });
    std::cout << "emitters   " << area_lights + static_cast<std::ptrdiff_t>(scene.point_lights.size()) << ": " << area_lights << " area, "
              << scene.point_lights.size() << " point\n";
    for (const PointLight& light : scene.point_lights) {
        std::cout << "  point at " << vector_text(light.position) << ", intensity " << vector_text(light.intensity) << "\n";
    }
}

void print_materials(const Scene& scene) {
    std::cout << "materials  " << scene.bsdfs.size() << "\n";
    for (const Diffuse& bsdf : scene.bsdfs) {
        std::cout << "  " << (bsdf.id.empty() ? "(unnamed)" : printable(bsdf.id)) << ": diffuse, albedo " << vector_text(bsdf.albedo)
                  << (bsdf.two_sided ? ", two-sided" : "") << "\n";
    }
}

void print_film(const Scene& scene) {
    const char* const filters[] = {"box", "tent", "gaussian", "mitchell", "catmullrom", "lanczos"};
    const PerspectiveSensor& sensor = scene.sensor;
    std::cout << "film       " << sensor.width << "x" << sensor.height << ", " << filters[static_cast<int>(sensor.filter.kind)]
              << " filter of radius " << format_short(sensor.filter.radius) << ", horizontal field of view " << format_short(sensor.fov_x)
              << " degrees\nmax_depth  " << (scene.max_depth < 0 ? "no limit" : std::to_string(scene.max_depth)) << "\n";
}

/// One line per feature that a scene can ask for: needed, or what its absence saves.
void print_needs(const Scene& scene) {
    const auto line = [](bool needed, const std::string& feature, const std::string& saving) {
        std::cout << "  " << (needed ? "needed    " : "left out  ") << feature << (needed ? "" : ": " + saving) << "\n";
    };
    const bool lights = !scene.point_lights.empty();
    const bool area = std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) { return shape.emits; });
    const bool smooth = std::any_of(scene.triangles.begin(), scene.triangles.end(), [&](const Triangle3& triangle) {
        const glm::vec3 normal = triangle.corners[0] < scene.normals.size() ? scene.normals[triangle.corners[0]] : glm::vec3(0.0F);
        return normal != glm::vec3(0.0F);
    });
    const bool reflects = std::any_of(scene.bsdfs.begin(), scene.bsdfs.end(), [](const Diffuse& d) { return d.albedo != glm::vec3(0.0F); });
    const bool indirect = reflects && (lights || area) && !scene.triangles.empty() && (scene.max_depth < 0 || scene.max_depth > 2);
    std::cout << "features\n";
    line(area, "area emitters", "no emitted radiance in maps or film");
    line(lights, "point lights", "no light samples of points");
    line(smooth, "shading normals", "every triangle is flat; its plane's normal is used");
    line(indirect, "indirect light", "nothing reflects light twice; no pencil transport");
}

}  // namespace

ExitCode run_info(const InfoCommand& command) {
    const Scene scene = load_scene(command.scene, {command.defines});
    for (const std::string& warning : scene.warnings) {
        print_warning(warning);
    }
    std::cout << "scene      " << printable(command.scene.string()) << "\n";
    print_shapes(scene);
    print_lights(scene);
    print_materials(scene);
    print_film(scene);
    print_bounds(scene);
    print_needs(scene);
    return ExitCode::ok;
}

}  // namespace pencil
