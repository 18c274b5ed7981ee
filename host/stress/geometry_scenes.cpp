#include "stress/geometry_scenes.h"

#include <cmath>
#include <tuple>

#include "stress/stress_scenes.h"
#include "util/constants.h"

namespace pencil {

namespace {

constexpr float half = 0.5F;
const Paint white_both{glm::vec3(1.0F), glm::vec3(0.0F), true};

/// Evenly spread numbers in [0, 1) that do not repeat: multiples of the golden ratio.
double spread(std::size_t i, double shift) { return std::fmod(static_cast<double>(i) * 0.61803398874989485 + shift, 1.0); }

}  // namespace

Scene dust_scene(std::size_t count, double size) {
    Scene scene = furnace_room(half);
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 at(2 * spread(i, 0.1) - 0.9, 1.8 * spread(i / 7, 0.2) - 0.9, 1.8 * spread(i / 49, 0.3) - 0.9);
        for (const glm::dvec3& step : {glm::dvec3(0), glm::dvec3(size, 0.3 * size, 0), glm::dvec3(0, size, 0.7 * size)})
            corners.push_back(at + step);
    }
    add_triangles(scene, corners, white_both);
    return scene;
}

Scene needle_scene() {
    Scene scene = furnace_room(half);
    std::vector<glm::dvec3> corners;
    for (std::size_t i = 0; i < 500; ++i) {
        const glm::dvec3 from(-0.9, 1.8 * spread(i, 0.2) - 0.9, 1.8 * spread(i / 9, 0.3) - 0.9),
            to(1.4, 1.8 * spread(i / 5, 0.5) - 0.9, 1.8 * spread(i / 11, 0.7) - 0.9);
        corners.insert(corners.end(), {from, to, from + glm::dvec3(0, 2e-6, 1e-6)});
    }
    add_triangles(scene, corners, white_both);
    return scene;
}

Scene decades_scene() {
    Scene scene;
    double inner = 0;
    for (int k = -6; k <= 6; ++k) {
        const double outer = std::pow(10.0, k), w = 2 * outer, strip = outer - inner;
        const Paint paint{glm::vec3(half)};
        if (inner == 0) {
            add_floor(scene, outer, paint);
        } else {
            add_sheet(scene, {-outer, 0, -outer}, {0, 0, strip}, {w, 0, 0}, paint);
            add_sheet(scene, {-outer, 0, inner}, {0, 0, strip}, {w, 0, 0}, paint);
            add_sheet(scene, {-outer, 0, -inner}, {0, 0, 2 * inner}, {strip, 0, 0}, paint);
            add_sheet(scene, {inner, 0, -inner}, {0, 0, 2 * inner}, {strip, 0, 0}, paint);
        }
        inner = outer;
    }
    scene.environment = Environment{};
    look(scene, {0, 1e-3, 0}, {5e-4, 0, 5e-4}, 60, 16, 12);
    return scene;
}

Scene near_floor_scene(double d) {
    Scene scene;
    add_floor(scene, 20, {glm::vec3(half)});
    add_sheet(scene, {-0.01, 1, -0.01}, {0.02, 0, 0}, {0, 0, 0.02}, {glm::vec3(half)});
    scene.point_lights.push_back({{0, d, 0}, glm::vec3(1.0F)});
    look(scene, {0, 0.9, 0}, {0, 1, 0}, 2, 8, 8);
    return scene;
}

/// A closed box of 1 mm with walls of a hundredth of that, on a lit floor of 1 km.
Scene millimetre_box() {
    Scene scene;
    const Paint wall{glm::vec3(half), glm::vec3(0.0F), false};
    const double size = 1e-3, thick = 1e-5;
    add_floor(scene, 500, wall);
    add_room(scene, {-size, thick, -size}, {size, 2 * size, size}, wall);
    for (const auto& [corner, u, v] : {std::tuple{glm::dvec3(-1, 0, 1), glm::dvec3(2, 0, 0), glm::dvec3(0, 2, 0)},
                                       std::tuple{glm::dvec3(1, 0, -1), glm::dvec3(-2, 0, 0), glm::dvec3(0, 2, 0)},
                                       std::tuple{glm::dvec3(1, 0, 1), glm::dvec3(0, 0, -2), glm::dvec3(0, 2, 0)},
                                       std::tuple{glm::dvec3(-1, 0, -1), glm::dvec3(0, 0, 2), glm::dvec3(0, 2, 0)},
                                       std::tuple{glm::dvec3(-1, 2, -1), glm::dvec3(0, 0, 2), glm::dvec3(2, 0, 0)}}) {
        const double s = size + thick;
        add_sheet(scene, s * corner, s * u, s * v, wall);
    }
    scene.point_lights.push_back({{3, 5, 2}, glm::vec3(1e3F)});
    look(scene, {0, 0.8 * size, -0.5 * size}, {0, 0.5 * size, size}, 80, 16, 12);
    return scene;
}

Scene maze() {
    Scene scene;
    const Paint wall{glm::vec3(half), glm::vec3(0.0F), true};
    add_room(scene, glm::dvec3(0), {4, 1, 1}, wall);
    for (int k = 1; k < 4; ++k) add_sheet(scene, {k, 0, k % 2 == 0 ? 0.2 : 0.0}, {0, 1, 0}, {0, 0, 0.8}, wall);
    add_sheet(scene, {0.3, 0.95, 0.3}, {0.4, 0, 0}, {0, 0, 0.4}, {glm::vec3(0.0F), glm::vec3(10.0F)});
    look(scene, {3.9, 0.5, 0.5}, {3.0, 0.45, 0.5}, 80, 16, 12);
    return scene;
}

/// A two-sided sphere about the eye, in a room with a lamp.
Scene eye_in_a_sphere() {
    Scene scene = furnished_room();
    const glm::dvec3 centre(0.25, 0.5, 0.25);
    const auto at = [&](int i, int j) {
        const double theta = pi * i / 8, phi = pi * j / 8;
        return centre + 0.15 * glm::dvec3(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
    };
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 16; ++j)
            corners.insert(corners.end(), {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    add_triangles(scene, corners, {glm::vec3(0.8F), glm::vec3(0.0F), true});
    look(scene, centre, centre + glm::dvec3(0.1, 0.02, 0.1), 80, 16, 12);
    return scene;
}

}  // namespace pencil
