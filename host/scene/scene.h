// A scene as its file describes it: world coordinates in double precision, one triangle list, Mitsuba's semantics.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "shared/material.h"

namespace pencil {

/// Reflection of the front side (counter-clockwise corners), of both sides if two_sided.
struct SceneMaterial {
    std::string id;  // from the file, or empty
    int model = MATERIAL_DIFFUSE;
    glm::vec3 albedo{0.5F};  // linear sRGB, each in [0, 1]
    bool two_sided = false;
    glm::vec3 parameters{0.0F};  // of the model (shared/material.h)
};

struct Triangle3 {
    glm::uvec3 corners;          // indices into Scene::positions, normals and uvs
    std::uint32_t shape = 0;     // index into Scene::shapes
    std::uint32_t material = 0;  // index into Scene::materials
};

/// A name for triangles that belong together, and what they emit.
struct Shape {
    std::string id;    // from the file, or "rectangle 3": kind and ordinal
    std::string kind;  // rectangle, cube, sphere, obj, ply
    std::uint32_t first_triangle = 0;
    std::uint32_t triangle_count = 0;
    bool emits = false;
    glm::vec3 radiance{0.0F};  // of the front side [W m^-2 sr^-1]
};

struct PointLight {
    glm::dvec3 position;
    glm::vec3 intensity;  // [W sr^-1]
};

struct ReconstructionFilter {
    enum class Kind { box, tent, gaussian, mitchell, catmullrom, lanczos };
    Kind kind = Kind::gaussian;           // Mitsuba's default
    double radius = 2.0;                  // half width of the support [pixels]
    double stddev = 0.5;                  // gaussian
    double b = 1.0 / 3.0, c = 1.0 / 3.0;  // mitchell
};

/// Looks along +z of its own frame, +y up, +x to the left of the image (Mitsuba).
struct PerspectiveSensor {
    glm::dmat4 to_world{1.0};
    double fov_x = 45.0;  // horizontal field of view [degrees], after fov_axis has been resolved
    double near_clip = 0.01, far_clip = 10000.0;
    int width = 768, height = 576;
    glm::dvec2 principal_point_offset{0.0};
    ReconstructionFilter filter;
};

struct Scene {
    std::string file;
    std::vector<glm::dvec3> positions;
    std::vector<glm::vec3> normals;  // unit shading normals, one per position; zero: use the face normal
    std::vector<glm::vec2> uvs;  // texture coordinates as Mitsuba's, one per position, zero where a shape has none; empty if all have none
    std::vector<Triangle3> triangles;
    std::vector<Shape> shapes;
    std::vector<SceneMaterial> materials;
    std::vector<PointLight> point_lights;
    PerspectiveSensor sensor;
    int max_depth = -1;  // 1: emission only, 2: plus direct light, -1: no limit
    std::vector<std::string> warnings;
};

}  // namespace pencil
