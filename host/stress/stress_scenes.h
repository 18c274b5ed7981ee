// Scenes of the stress cases, built in memory: boxes, sheets and lamps of flat triangles, y up, corners counter-clockwise seen from the front.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace pencil {

struct Paint {
    glm::vec3 albedo{0.5F};
    glm::vec3 radiance{0.0F};
    bool two_sided = false;
};

/// A shape of triangles, three corners each.
void add_triangles(Scene& scene, const std::vector<glm::dvec3>& corners, const Paint& paint);
/// The parallelogram corner, corner + u, corner + u + v, corner + v; its front is the side that cross(u, v) points to.
void add_sheet(Scene& scene, const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, const Paint& paint);
/// The six sides of a box, seen from inside.
void add_room(Scene& scene, const glm::dvec3& low, const glm::dvec3& high, const Paint& paint);
/// A square floor at y = 0 about the origin, its front up.
void add_floor(Scene& scene, double half_width, const Paint& paint);
/// A pinhole with a box filter, `fov` degrees across the width.
void look(Scene& scene, const glm::dvec3& from, const glm::dvec3& to, double fov, int width, int height);

/// A closed box whose walls emit 1 and reflect `albedo`: the radiance is 1 / (1 - albedo) everywhere.
Scene furnace_room(float albedo, int width = 16, int height = 12);
/// A closed cube of 2 m with a point light in its middle; the film is one wall. Mean radiance of the wall: lit_cube_answer.
Scene lit_cube(float albedo, float intensity = 1.0F);
/// By the balance of energy: flux 4 pi I over (1 - albedo) times the surface, times albedo / pi.
double lit_cube_answer(double albedo, double intensity = 1.0);
/// A room with a lamp under its ceiling and a block on the floor.
Scene furnished_room(float radiance = 1.0F);

}  // namespace pencil
