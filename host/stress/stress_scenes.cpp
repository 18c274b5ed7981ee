#include "stress/stress_scenes.h"

#include <glm/geometric.hpp>
#include <utility>

namespace pencil {

namespace {

/// Side `side` (0 low, 1 high) across `axis` of a box.
void add_side(Scene& scene, int axis, int side, const glm::dvec3& low, const glm::dvec3& high, bool inward, const Paint& paint) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    glm::dvec3 corner = low, u(0), v(0);
    u[a] = high[a] - low[a];
    v[b] = high[b] - low[b];
    corner[axis] = side == 1 ? high[axis] : low[axis];
    if ((side == 1) == inward) std::swap(u, v);
    add_sheet(scene, corner, u, v, paint);
}

void add_box(Scene& scene, const glm::dvec3& low, const glm::dvec3& high, bool inward, const Paint& paint) {
    for (int axis = 0; axis < 3; ++axis)
        for (int side = 0; side < 2; ++side) add_side(scene, axis, side, low, high, inward, paint);
}

}  // namespace

void add_triangles(Scene& scene, const std::vector<glm::dvec3>& corners, const Paint& paint) {
    Shape shape;
    shape.id = "shape " + std::to_string(scene.shapes.size() + 1);
    shape.kind = "obj";
    shape.first_triangle = static_cast<std::uint32_t>(scene.triangles.size());
    shape.triangle_count = static_cast<std::uint32_t>(corners.size() / 3);
    shape.emits = paint.radiance != glm::vec3(0.0F);
    shape.radiance = paint.radiance;
    SceneMaterial material;
    material.albedo = paint.albedo;
    material.two_sided = paint.two_sided;
    const auto number = static_cast<std::uint32_t>(scene.shapes.size()), row = static_cast<std::uint32_t>(scene.materials.size());
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const auto first = static_cast<std::uint32_t>(scene.positions.size());
        scene.positions.insert(scene.positions.end(), {corners[i], corners[i + 1], corners[i + 2]});
        scene.normals.insert(scene.normals.end(), 3, glm::vec3(0.0F));
        scene.triangles.push_back({{first, first + 1, first + 2}, number, row});
    }
    scene.shapes.push_back(shape);
    scene.materials.push_back(material);
}

void add_sheet(Scene& scene, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, const Paint& paint) {
    add_triangles(scene, {corner, corner + u, corner + u + v, corner, corner + u + v, corner + v}, paint);
}

void add_room(Scene& scene, const glm::dvec3& low, const glm::dvec3& high, const Paint& paint) { add_box(scene, low, high, true, paint); }

void add_floor(Scene& scene, double half_width, const Paint& paint) {
    add_sheet(scene, {-half_width, 0, -half_width}, {0, 0, 2 * half_width}, {2 * half_width, 0, 0}, paint);
}

void look(Scene& scene, const glm::dvec3& from, const glm::dvec3& to, double fov, int width, int height) {
    const glm::dvec3 forward = glm::normalize(to - from), world_up = std::abs(forward.y) < 0.99 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1),
                     left = glm::normalize(glm::cross(world_up, forward)), up = glm::cross(forward, left);
    PerspectiveSensor& sensor = scene.sensor;
    sensor.to_world = glm::dmat4(glm::dvec4(left, 0), glm::dvec4(up, 0), glm::dvec4(forward, 0), glm::dvec4(from, 1));
    sensor.fov_x = fov;
    sensor.near_clip = 1e-6 * glm::distance(from, to);
    sensor.far_clip = 1e9 * glm::distance(from, to);
    sensor.width = width;
    sensor.height = height;
    sensor.filter.kind = ReconstructionFilter::Kind::box;
    sensor.filter.radius = 0.5;
}

Scene furnace_room(float albedo, int width, int height) {
    Scene scene;
    add_room(scene, {-1, -1, -1}, {1.5, 1, 1}, {glm::vec3(albedo), glm::vec3(1.0F)});
    look(scene, {-0.7, 0.2, 0.6}, {1.2, -0.3, -0.8}, 90, width, height);
    return scene;
}

Scene lit_cube(float albedo, float intensity) {
    Scene scene;
    add_room(scene, glm::dvec3(-1), glm::dvec3(1), {glm::vec3(albedo)});
    scene.point_lights.push_back({glm::dvec3(0), glm::vec3(intensity)});
    look(scene, glm::dvec3(0), {1, 0, 0}, 90, 16, 16);
    return scene;
}

double lit_cube_answer(double albedo, double intensity) {
    constexpr double surface = 24;
    return 4 * intensity * albedo / (surface * (1 - albedo));
}

Scene furnished_room(float radiance) {
    Scene scene;
    add_room(scene, glm::dvec3(0), {1, 1, 1.25}, {{0.7F, 0.6F, 0.5F}});
    add_sheet(scene, {0.375, 0.96875, 0.375}, {0.25, 0, 0}, {0, 0, 0.25}, {glm::vec3(0.0F), radiance * glm::vec3(10, 9, 8)});
    add_box(scene, {0.5625, 0, 0.5}, {0.8125, 0.5, 0.75}, false, {glm::vec3(0.6F)});
    look(scene, {0.25, 0.5, 0.0625}, {0.5, 0.375, 1}, 70, 32, 24);
    return scene;
}

}  // namespace pencil
