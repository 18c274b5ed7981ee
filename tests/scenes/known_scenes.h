// Scenes whose light is known in closed form, or known to be absent, and one that has everything. The pencil renderer and the reference path tracer are tested on them.
#pragma once

#include <utility>
#include <vector>

#include "reference/form_factor_ref.h"
#include "scenes/scene_parts.h"

namespace pencil::test {

/// Closed box: every wall emits 1 and reflects `albedo`. The radiance is 1 / (1 - albedo) everywhere.
inline Scene furnace(float albedo) {
    Scene scene;
    add_box(scene, {-1, -1, -1}, {1.5, 1, 1}, {glm::vec3(albedo), glm::vec3(1.0F), false});
    look_at(scene, {-0.7, 0.2, 0.6}, {1.2, -0.3, -0.8}, {0, 1, 0}, 90.0, 48, 32);
    return scene;
}

/// Unit box, the wall x = 0 emits 1, the others only receive, albedo 1. See ref::lit_wall_irradiance.
inline Scene lit_wall_box() {
    Scene scene;
    for (int wall = 0; wall < 6; ++wall) {
        const Surface lit{glm::vec3(0.0F), glm::vec3(1.0F), false}, receiver{glm::vec3(1.0F), glm::vec3(0.0F), false};
        add_wall(scene, wall, dvec3(0.0), dvec3(1.0), wall == 0 ? lit : receiver);
    }
    // From the box's middle straight down: with 90 degrees the film is exactly the floor.
    look_at(scene, {0.5, 0.5, 0.5}, {0.5, 0, 0.5}, {0, 0, 1}, 90.0, 200, 200);
    return scene;
}

/// Inward sphere of radius r about the origin: latitude-longitude, flat faces.
inline std::vector<Face> inward_sphere(double r, int rings) {
    std::vector<Face> faces;
    const auto at = [&](int i, int j) {
        const double theta = ref::pi * i / rings, phi = ref::pi * (j % (2 * rings)) / rings;
        return dvec3(r * std::sin(theta) * std::cos(phi), r * std::cos(theta), r * std::sin(theta) * std::sin(phi));
    };
    for (int i = 0; i < rings; ++i) {
        for (int j = 0; j < 2 * rings; ++j) {
            const auto add = [&](dvec3 a, dvec3 b, dvec3 c) {
                if (glm::dot(glm::cross(b - a, c - a), a + b + c) > 0.0) std::swap(b, c);
                faces.push_back({a, b, c});
            };
            if (i > 0) add(at(i, j), at(i, j + 1), at(i + 1, j));
            if (i < rings - 1) add(at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
        }
    }
    return faces;
}

/// Two unit rooms side by side along x; the lit one is at x < 1. `thickness` 0: one two-sided sheet between them.
inline Scene two_rooms(double thickness, bool lamp_is_area) {
    const Surface white{glm::vec3(0.8F), glm::vec3(0.0F), false}, white_both{glm::vec3(0.8F), glm::vec3(0.0F), true};
    Scene scene;
    add_box(scene, {0, 0, 0}, {2, 1, 1}, white);
    if (thickness > 0.0) {
        add_wall(scene, 1, {0, 0, 0}, {1 - thickness / 2, 1, 1}, white);
        add_wall(scene, 0, {1 + thickness / 2, 0, 0}, {2, 1, 1}, white);
    } else {
        add_quad(scene, "sheet", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, white_both);
    }
    if (lamp_is_area)
        add_quad(scene, "lamp", {0.3, 0.95, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.0F), glm::vec3(10.0F), false});
    else
        scene.point_lights.push_back({{0.5, 0.9, 0.5}, glm::vec3(10.0F)});
    look_at(scene, {1.9, 0.5, 0.1}, {1.0, 0.45, 0.9}, {0, 1, 0}, 95.0, 64, 64);
    return scene;
}

/// A polygon of radiance 1 over a floor y = 0.
struct Luminaire {
    const char* name;
    std::vector<dvec3> corners;  // counter-clockwise seen from the origin, which sees the front
};

/// Five as different as polygons are: a triangle overhead, a small square far away, a pentagon, a tilted one that dips below the horizon,
/// and a long one close to the floor.
inline const std::vector<Luminaire>& luminaires() {
    static const std::vector<Luminaire> all{
        {"triangle", {{-0.5, 1, -0.4}, {0.6, 1, -0.3}, {0, 1, 0.7}}},
        {"square", {{2.9, 2.0, -0.1}, {3.1, 2.0, -0.1}, {3.1, 2.0, 0.1}, {2.9, 2.0, 0.1}}},
        {"pentagon", {{0.2, 0.81, 0.9}, {1.0, 0.87, 0.7}, {1.3, 0.97, 1.4}, {0.7, 0.95, 1.8}, {0.1, 0.86, 1.5}}},
        {"tilted", {{-1.5, -0.5, -1}, {-1.0, 1.5, -1}, {-1.0, 1.5, 1}, {-1.5, -0.5, 1}}},
        {"strip", {{0.3, 0.2, -2}, {0.5, 0.2, -2}, {0.5, 0.2, 2}, {0.3, 0.2, 2}}}};
    return all;
}

constexpr double luminaire_floor_albedo = 0.5;

/// What the floor reflects at the origin, by Lambert's formula.
inline double luminaire_answer(const Luminaire& luminaire) {
    return luminaire_floor_albedo / ref::pi * ref::polygon_irradiance(luminaire.corners, dvec3(0.0), {0, 1, 0});
}

/// The floor about the origin, so near that all pixels show one value.
inline Scene luminaire_scene(const Luminaire& luminaire) {
    Scene scene;
    add_quad(scene, "floor", {-4, 0, -4}, {0, 0, 8}, {8, 0, 0}, {glm::vec3(luminaire_floor_albedo), glm::vec3(0.0F), false});
    std::vector<Face> faces;
    for (std::size_t i = 2; i < luminaire.corners.size(); ++i)
        faces.push_back({luminaire.corners[0], luminaire.corners[i - 1], luminaire.corners[i]});
    add_shape(scene, luminaire.name, faces, {glm::vec3(0.0F), glm::vec3(1.0F), false});
    look_at(scene, {0, 0.1, 0}, dvec3(0.0), {0, 0, 1}, 0.5, 8, 8);
    return scene;
}

/// CIE 171:2006 test 5.8: a closed cube of 4 m with a source of 10 000 lm in its middle, all walls of one albedo. The film is one wall.
inline Scene cie_cube(double albedo) {
    constexpr double flux = 10000.0;
    Scene scene;
    add_box(scene, dvec3(0.0), dvec3(4.0), {glm::vec3(static_cast<float>(albedo)), glm::vec3(0.0F), false});
    scene.point_lights.push_back({dvec3(2.0), glm::vec3(static_cast<float>(flux / (4.0 * ref::pi)))});
    look_at(scene, dvec3(2.0), {4, 2, 2}, {0, 1, 0}, 90.0, 32, 32);
    return scene;
}

/// Mean illuminance of its walls by energy balance, flux / (surface (1 - albedo)) [lx].
inline double cie_cube_answer(double albedo) { return 10000.0 / (96.0 * (1.0 - albedo)); }

/// A room with everything: an area light, a point light, a block, one-sided and two-sided surfaces, an open side.
inline Scene room_of_everything() {
    Scene scene;
    const Surface grey{glm::vec3(0.7F, 0.5F, 0.3F), glm::vec3(0.0F), false}, both{glm::vec3(0.4F), glm::vec3(0.0F), true};
    for (int wall = 0; wall < 5; ++wall) add_wall(scene, wall, dvec3(-1), dvec3(1), grey);
    add_box(scene, {-0.5, -1, -0.3}, {0, -0.2, 0.3}, grey, false);
    add_quad(scene, "sheet", {0.3, -0.5, -0.2}, {0.4, 0.2, 0}, {0, 0.3, 0.4}, both);
    add_quad(scene, "lamp", {-0.3, 0.99, -0.3}, {0.5, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.2F), glm::vec3(8, 6, 4), false});
    scene.point_lights.push_back({{0.6, 0.2, 0.1}, glm::vec3(0.3F)});
    look_at(scene, {0.1, 0.1, 3.5}, {0, 0, 0}, {0, 1, 0}, 45.0, 20, 14);
    scene.sensor.filter.kind = ReconstructionFilter::Kind::gaussian;
    scene.sensor.filter.radius = 2.0;
    return scene;
}

/// Closed room of unit albedo 0.8 with a small cube for a lamp, `gap` below the ceiling that the camera looks up at.
/// Two closed rooms that have nothing in common, each as bright everywhere as emission / (1 - albedo): 0.02 and 1. The camera begins inside both; the
/// last tenth of the image's columns shows the second.
inline Scene two_furnaces() {
    Scene scene;
    add_box(scene, {-1, -0.75, -1}, {0.7, 0.75, 1}, {glm::vec3(0.5F), glm::vec3(0.01F)});
    add_box(scene, {0.75, -0.75, -1}, {1, 0.75, 1}, {glm::vec3(0.9F), glm::vec3(0.1F)});
    look_at(scene, {0, 0, 2}, {0, 0, 0}, {0, 1, 0}, 65.8, 48, 36);
    scene.sensor.near_clip = 1.5;
    return scene;
}

inline Scene room_with_near_lamp(double gap) {
    const Surface white{glm::vec3(0.8F), glm::vec3(0.0F), false}, lamp{glm::vec3(0.0F), glm::vec3(100.0F), false};
    Scene scene;
    add_box(scene, {0, 0, 0}, {4, 3, 5}, white);
    constexpr double side = 0.05;
    const dvec3 low(2.6, 3 - gap - side, 2.3);
    add_box(scene, low, low + side, lamp, false);
    look_at(scene, {0.6, 1.2, 0.5}, {3.2, 2.7, 3.6}, {0, 1, 0}, 80.0, 32, 24);
    return scene;
}

}  // namespace pencil::test
